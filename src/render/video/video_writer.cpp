#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string>
#include <utility>

#include "render/video/encoder_arguments.hpp"
#include "render/video/encoder_process.hpp"
#include "render/video/pipe_copy.hpp"
#include "tumble/file.hpp"
#include "tumble/recording.hpp"

namespace tumble {

namespace fs = std::filesystem;

namespace {

// The last line that is not empty.
std::string last_line(std::string text) {
    while (text.ends_with('\n')) text.pop_back();
    return text.substr(text.rfind('\n') + 1);  // npos + 1 is 0
}

}  // namespace

std::optional<VideoFormat> video_format_of(const fs::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    if (extension == ".mp4") return VideoFormat::mp4;
    if (extension == ".webm") return VideoFormat::webm;
    if (extension == ".gif") return VideoFormat::gif;
    if (extension == ".apng") return VideoFormat::apng;
    return std::nullopt;
}

struct VideoWriter::Impl {
    Impl(fs::path path, const VideoSettings& settings_)
        : settings(settings_),
          file(std::move(path)),
          copy(make_copy(file, settings)),
          encoder(render::encoder_arguments(settings, file.temporary().string()), copy ? copy->entry() : -1) {
        if (copy) copy->close_entry();
    }

    // Waits for the end. Throws for a file that could not be written, and as throw_if_failed().
    void finish(bool must_fail) {
        const render::EncoderProcess::End& end = encoder.wait();
        if (copy) copy->finish();
        throw_if_failed(end, must_fail);
    }

    // Throws for an encoder that has ended, or has not encoded everything.
    void throw_if_failed(const render::EncoderProcess::End& end, bool must_fail) const {
        constexpr const char* kFull = "No space left on device";
        if (end.messages.find(kFull) != std::string::npos)
            throw FileError(file.path(), std::string("cannot write: ") + kFull);
        if (end.exit_code == 0 && !must_fail) return;
        const std::string message = end.messages.empty() ? "" : ": " + last_line(end.messages);
        throw RenderError(file.path().string() + ": ffmpeg " + how(end) + message);
    }

    const VideoSettings settings;
    OutputFile file;                         // outlives the encoder, which writes to its temporary file
    std::unique_ptr<render::PipeCopy> copy;  // to standard output
    render::EncoderProcess encoder;

private:
    // ffmpeg cannot go back in standard output, as it does at the end of an APNG.
    static std::unique_ptr<render::PipeCopy> make_copy(OutputFile& file, const VideoSettings& settings) {
        if (!file.temporary().empty()) return nullptr;
        if (settings.format == VideoFormat::apng) throw FileError(file.path(), "an APNG needs a file");
        return std::make_unique<render::PipeCopy>(file);
    }

    static std::string how(const render::EncoderProcess::End& end) {
        if (end.signal != 0) return "was ended by signal " + std::to_string(end.signal);
        if (end.exit_code < 0) return "ended with an unknown exit code";
        return "failed with exit code " + std::to_string(end.exit_code);
    }
};

void require_encoder() { render::EncoderProcess({"ffmpeg", "-loglevel", "quiet", "-version"}); }

VideoWriter::VideoWriter(fs::path file, const VideoSettings& settings)
    : impl_(std::make_unique<Impl>(std::move(file), settings)) {}
VideoWriter::~VideoWriter() = default;
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;

void VideoWriter::write(const Image& image) {
    const VideoSettings& settings = impl_->settings;
    if (image.width != settings.width || image.height != settings.height)
        throw std::invalid_argument("a frame of " + std::to_string(image.width) + "x" + std::to_string(image.height) +
                                    " for a video of " + std::to_string(settings.width) + "x" +
                                    std::to_string(settings.height));
    if (!impl_->encoder.send(image.rgba)) impl_->finish(true);
}

std::uint64_t VideoWriter::finish() {
    impl_->finish(false);
    if (!impl_->copy) impl_->file.take_from_others();
    return impl_->file.commit();
}

}  // namespace tumble
