#include "tools/sweep/runs/run_video.hpp"

#include <array>
#include <cstdio>
#include <filesystem>

#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

fs::path video_in(const TemporaryFolder& folder) { return folder.path() / "frames.mp4"; }

}  // namespace

std::string encoder_version() {
    std::string line;
    if (FILE* const pipe = ::popen("ffmpeg -version 2> /dev/null", "r"); pipe != nullptr) {
        std::array<char, 256> text{};
        if (std::fgets(text.data(), text.size(), pipe) != nullptr) line = text.data();
        while (std::fgets(text.data(), text.size(), pipe) != nullptr) continue;
        ::pclose(pipe);
    }
    if (!line.starts_with("ffmpeg version "))
        throw RenderError(
            "the program ffmpeg, which encodes videos, is not installed (Debian: apt-get install "
            "--no-install-recommends ffmpeg); frames as PNG do not need it");
    return line.substr(0, line.find(' ', std::string("ffmpeg version ").size()));
}

RunVideo::RunVideo(int width, int height, double frames_per_second)
    : video_(video_in(folder_), {VideoFormat::mp4, width, height, frames_per_second}) {}

std::string RunVideo::finish() {
    video_.finish();
    return read_file(video_in(folder_));
}

}  // namespace tumble::tools
