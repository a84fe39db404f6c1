#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "render/video/encoder_arguments.hpp"
#include "render/video/encoder_process.hpp"
#include "tumble/file.hpp"
#include "tumble/video.hpp"

namespace tumble {

namespace fs = std::filesystem;

namespace {

// A file in which ffmpeg writes, beside the one that it becomes; removed if it does not become it.
class TemporaryFile {
public:
    explicit TemporaryFile(const fs::path& file) : path_(file) {
        static std::atomic<unsigned> serial{0};
        path_ += "." + std::to_string(::getpid()) + "-" + std::to_string(serial++) + ".partial";
        const int descriptor = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor < 0) throw FileError(file, "cannot write: " + std::generic_category().message(errno));
        ::close(descriptor);
    }
    ~TemporaryFile() {
        if (!path_.empty()) ::unlink(path_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const fs::path& path() const noexcept { return path_; }

    std::uint64_t become(const fs::path& file) {
        std::error_code error;
        const std::uint64_t size = fs::file_size(path_, error);
        if (!error) fs::rename(path_, file, error);
        if (error) throw FileError(file, "cannot write: " + error.message());
        path_.clear();
        return size;
    }

private:
    fs::path path_;
};

// The last line that is not empty.
std::string last_line(std::string words) {
    while (words.ends_with('\n')) words.pop_back();
    return words.substr(words.rfind('\n') + 1);  // npos + 1 is 0
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
    Impl(fs::path file_, const VideoSettings& settings_)
        : file(std::move(file_)),
          settings(settings_),
          temporary(file),
          encoder(render::encoder_arguments(settings, temporary.path().string())) {}

    // Throws for an encoder that has ended, or has not encoded everything.
    void throw_if_failed(const render::EncoderProcess::End& end, bool must_fail) const {
        constexpr const char* kFull = "No space left on device";
        if (end.words.find(kFull) != std::string::npos) throw FileError(file, std::string("cannot write: ") + kFull);
        if (end.exit_code == 0 && !must_fail) return;
        const std::string how = end.signal != 0 ? "was ended by signal " + std::to_string(end.signal)
                                                : "failed with exit code " + std::to_string(end.exit_code);
        throw RenderError(file.string() + ": ffmpeg " + how + (end.words.empty() ? "" : ": " + last_line(end.words)));
    }

    const fs::path file;
    const VideoSettings settings;
    TemporaryFile temporary;  // outlives the encoder that writes to it
    render::EncoderProcess encoder;
};

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
    if (!impl_->encoder.send(image.rgba)) impl_->throw_if_failed(impl_->encoder.wait(), true);
}

std::uint64_t VideoWriter::finish() {
    impl_->throw_if_failed(impl_->encoder.wait(), false);
    return impl_->temporary.become(impl_->file);
}

}  // namespace tumble
