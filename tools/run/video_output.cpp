#include "tools/run/video_output.hpp"

#include <CLI/CLI.hpp>

#include <cmath>
#include <optional>
#include <string>

#include "tools/cli/output_path.hpp"

namespace tumble::tools {

namespace {

VideoFormat format_of(const std::filesystem::path& file) {
    if (is_standard_output(file)) return VideoFormat::mp4;
    if (const std::optional<VideoFormat> format = video_format_of(file)) return *format;
    throw CLI::ValidationError("--video",
                               "the name of a video ends in .mp4, .webm, .gif or .apng, got " + file.string());
}

std::string gigabytes(double bytes) { return std::to_string(std::llround(bytes / 1e9)) + " GB"; }

}  // namespace

VideoSettings video_settings(const std::filesystem::path& file, FrameSize size, double frames_per_second) {
    const VideoFormat format = format_of(file);
    const bool needs_even = format == VideoFormat::mp4 || format == VideoFormat::webm;
    if (needs_even && !size.is_even())
        throw CLI::ValidationError("--size",
                                   "the width and height of a video must be even: its colours have half the "
                                   "resolution");
    return {.format = format, .width = size.width, .height = size.height, .frames_per_second = frames_per_second};
}

void require_memory(const VideoSettings& settings, std::uint64_t frames, const std::string& option,
                    const std::string& remedy) {
    const double bytes = 4.0 * settings.width * settings.height * static_cast<double>(frames);
    if (settings.format == VideoFormat::gif && bytes > kMostGifBytes)
        throw CLI::ValidationError(option, "a GIF of this length and size needs " + gigabytes(bytes) +
                                               " of memory, more than " + gigabytes(kMostGifBytes) + ": " + remedy);
}

VideoWriter start_video(const std::filesystem::path& file, const VideoSettings& settings) {
    create_folder_of(file);
    return VideoWriter(file, settings);
}

}  // namespace tumble::tools
