// The file of a video: what its name and its size allow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "tools/run/run_options.hpp"
#include "tumble/recording.hpp"

namespace tumble::tools {

// The settings of a video with this name, an MP4 on standard output. Throws CLI::ValidationError if the name has no
// known extension, or if a side of the frames is odd and the format needs even ones.
VideoSettings video_settings(const std::filesystem::path& file, FrameSize size, double frames_per_second);

// ffmpeg keeps all frames of a GIF until it knows the colours of the last one, at four bytes a pixel.
inline constexpr double kMostGifBytes = 4e9;

// The memory that a video of so many frames needs while it is written; 0 unless it is a GIF.
double video_bytes(const VideoSettings& settings, std::uint64_t frames);

// How many GIFs of so many bytes kMostGifBytes allows at a time: at least one, at most `wanted`.
int gifs_at_a_time(double bytes, int wanted);

// Throws CLI::ValidationError if GIFs of so many frames, `count` of them written at a time, would need more memory than
// kMostGifBytes. `option` and `remedy` are named in its message.
void require_memory(const VideoSettings& settings, std::uint64_t frames, std::size_t count = 1,
                    const std::string& option = "--video",
                    const std::string& remedy = "lower --size, --fps or --duration, or write an .mp4");

// Creates the folder of the file and starts the encoder. Throws RenderError and FileError.
VideoWriter start_video(const std::filesystem::path& file, const VideoSettings& settings);

}  // namespace tumble::tools
