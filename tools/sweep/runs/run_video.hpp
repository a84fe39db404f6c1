// The frames of a run as the bytes of an MP4.
#pragma once

#include <string>

#include "tools/output/temporary_folder.hpp"
#include "tumble/recording.hpp"

namespace tumble::tools {

// The program that encodes videos: "ffmpeg version 5.1.9-0+deb12u1". Throws RenderError if it is not installed.
std::string encoder_version();

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
    TemporaryFolder folder_{"video"};
    VideoWriter video_;
};

}  // namespace tumble::tools
