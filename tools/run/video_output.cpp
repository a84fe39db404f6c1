#include "tools/run/video_output.hpp"

#include <CLI/CLI.hpp>

#include <cmath>
#include <string>

#include "tools/cli/output_path.hpp"

namespace tumble::tools {

namespace {

VideoFormat format_of(const RunOptions& options) {
    if (is_standard_output(options.video)) return VideoFormat::mp4;
    if (const std::optional<VideoFormat> format = video_format_of(options.video)) return *format;
    throw CLI::ValidationError("--video",
                               "the name of a video ends in .mp4, .webm, .gif or .apng, got " + options.video.string());
}

std::string gigabytes(double bytes) { return std::to_string(std::llround(bytes / 1e9)) + " GB"; }

}  // namespace

void require_video(const RunOptions& options, const FrameSchedule& schedule) {
    const VideoFormat format = format_of(options);
    const bool needs_even = format == VideoFormat::mp4 || format == VideoFormat::webm;
    if (needs_even && !options.size.is_even())
        throw CLI::ValidationError("--size",
                                   "the width and height of a video must be even: its colours have half the "
                                   "resolution");
    const double bytes = 4.0 * options.size.width * options.size.height * static_cast<double>(schedule.frame_count());
    if (format == VideoFormat::gif && bytes > kMostGifBytes)
        throw CLI::ValidationError("--video", "a GIF of this length and size needs " + gigabytes(bytes) +
                                                  " of memory, more than " + gigabytes(kMostGifBytes) +
                                                  ": lower --size, --fps or --duration, or write an .mp4");
}

VideoWriter start_video(const RunOptions& options) {
    create_folder_of(options.video);
    return VideoWriter(options.video, {.format = format_of(options),
                                       .width = options.size.width,
                                       .height = options.size.height,
                                       .frames_per_second = options.frames_per_second});
}

}  // namespace tumble::tools
