// The frames of a run as the bytes of an MP4.
#pragma once

#include <filesystem>
#include <string>

#include "tumble/recording.hpp"

namespace tumble::tools {

// The program that encodes videos: "ffmpeg version 5.1.9-0+deb12u1". Throws RenderError if it is not installed.
std::string encoder_version();

// A folder among the temporary files of the system, which is removed with all in it.
class TemporaryFolder {
public:
    TemporaryFolder();  // throws FileError
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const noexcept { return path_; }

private:
    std::filesystem::path path_;
};

// ffmpeg writes the video to a temporary folder.
class RunVideo {
public:
    // Sides in pixels, even. Throws RenderError if ffmpeg does not start, and FileError.
    RunVideo(int width, int height, double frames_per_second);

    // Throws as VideoWriter::write().
    void write(const Image& image) { video_.write(image); }

    // The bytes of the whole video. To be called once, last. Throws as VideoWriter::finish().
    std::string finish();

private:
    TemporaryFolder folder_;
    VideoWriter video_;
};

}  // namespace tumble::tools
