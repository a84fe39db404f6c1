#include "tools/run/video_output.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "tools/cli/output_path.hpp"
#include "tools/output/json_writer.hpp"

namespace tumble::tools {

namespace {

VideoFormat format_of(const std::filesystem::path& file) {
    if (is_standard_output(file)) return VideoFormat::mp4;
    if (const std::optional<VideoFormat> format = video_format_of(file)) return *format;
    throw CLI::ValidationError("--video",
                               "the name of a video ends in .mp4, .webm, .gif or .apng, got " + file.string());
}

// With one digit after the point, rounded up: what exceeds a limit is shown as more than it.
std::string gigabytes(double bytes) {
    std::string text;
    append_number(text, std::ceil(bytes / 1e8) / 10.0);
    return text + " GB";
}

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

double video_bytes(const VideoSettings& settings, std::uint64_t frames) {
    if (settings.format != VideoFormat::gif) return 0.0;
    return 4.0 * settings.width * settings.height * static_cast<double>(frames);
}

int gifs_at_a_time(double bytes, int wanted) {
    if (bytes * wanted <= kMostGifBytes) return wanted;
    return std::max(1, static_cast<int>(kMostGifBytes / bytes));
}

void require_memory(const VideoSettings& settings, std::uint64_t frames, std::size_t count, const std::string& option,
                    const std::string& remedy) {
    const double bytes = video_bytes(settings, frames) * static_cast<double>(count);
    if (bytes <= kMostGifBytes) return;
    const std::string subject = count == 1 ? "a GIF of this length and size needs "
                                           : std::to_string(count) + " GIFs of this length and size at a time need ";
    throw CLI::ValidationError(
        option, subject + gigabytes(bytes) + " of memory, more than " + gigabytes(kMostGifBytes) + ": " + remedy);
}

VideoWriter start_video(const std::filesystem::path& file, const VideoSettings& settings) {
    create_folder_of(file);
    return VideoWriter(file, settings);
}

}  // namespace tumble::tools
