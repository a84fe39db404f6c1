// The video of a run.
#pragma once

#include <filesystem>

#include "tools/run/frame_schedule.hpp"
#include "tools/run/run_options.hpp"
#include "tumble/recording.hpp"

namespace tumble::tools {

// Throws CLI::ValidationError if the name has no known extension, if the size is odd and the format needs an even one,
// or if a GIF would need more memory than kMostGifBytes.
void require_video(const RunOptions& options, const FrameSchedule& schedule);

// ffmpeg keeps all frames of a GIF until it knows the colours of the last one, at four bytes a pixel.
inline constexpr double kMostGifBytes = 4e9;

// Starts the encoder. The options must have passed require_video(). Throws RenderError and FileError.
VideoWriter start_video(const RunOptions& options);

}  // namespace tumble::tools
