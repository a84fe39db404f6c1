// Videos of frames, encoded by the program ffmpeg while they are drawn.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "tumble/render.hpp"

namespace tumble {

enum class VideoFormat { mp4, webm, gif, apng };

// By the extension, in any case: .mp4 (H.264), .webm (VP9), .gif, .apng. Nothing for others.
std::optional<VideoFormat> video_format_of(const std::filesystem::path& file);

struct VideoSettings {
    VideoFormat format = VideoFormat::mp4;
    int width = 0;  // pixels; even for mp4 and webm, whose colours have half the resolution
    int height = 0;
    double frames_per_second = 60.0;  // > 0; a GIF has at most 50, and leaves out frames above that
};

// A video with a constant frame rate: n frames last n / frames_per_second. The colours of mp4 and webm are yuv420p,
// BT.709. The same frames and the same ffmpeg give the same bytes, whatever the number of processors.
//
// All functions throw RenderError if ffmpeg is missing, fails or is ended, with its last line of error text, and
// FileError if the file cannot be written, such as on a full disk.
class VideoWriter {
public:
    // Starts ffmpeg, which writes to the temporary file of an OutputFile. For a GIF, ffmpeg keeps all frames until
    // finish(), because one palette serves all: four bytes a pixel, which the caller has to limit.
    VideoWriter(std::filesystem::path file, const VideoSettings& settings);
    ~VideoWriter();  // without finish(): ends ffmpeg and removes the temporary file
    VideoWriter(VideoWriter&&) noexcept;
    VideoWriter& operator=(VideoWriter&&) noexcept;

    // Appends a frame. Throws std::invalid_argument if it does not have the size of the video. Waits for ffmpeg if that
    // is several frames behind.
    void write(const Image& image);

    // Waits for ffmpeg and renames the file. Returns its size in bytes. To be called once, last, after a frame. After
    // an error of write() it throws the same error.
    std::uint64_t finish();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tumble
