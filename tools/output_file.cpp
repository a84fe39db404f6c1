#include "output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "tumble/scene.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kBufferSize = 1 << 16;  // bytes: large enough that the system call does not show

std::string reason(int error) { return std::generic_category().message(error); }

}  // namespace

void refuse_to_overwrite(const fs::path& file, bool force) {
    std::error_code ignored;
    if (!force && fs::exists(fs::symlink_status(file, ignored)))
        throw FileError(file, "exists already; give another name, or --force to replace it");
}

void create_folder_of(const fs::path& file) {
    if (!file.has_parent_path()) return;
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error) throw FileError(file.parent_path(), "cannot create the folder: " + error.message());
}

OutputFile::OutputFile(fs::path file, bool force) : path_(std::move(file)), temporary_(path_) {
    refuse_to_overwrite(path_, force);
    temporary_ += ".partial";
    create_folder_of(path_);
    descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw FileError(path_, "cannot write: " + reason(errno));
    buffer_.reserve(kBufferSize);
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_),
      buffer_(std::move(other.buffer_)) {}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::write(std::string_view text) {
    buffer_ += text;
    if (buffer_.size() >= kBufferSize) flush();
}

void OutputFile::flush() {
    std::string_view rest = buffer_;
    while (!rest.empty()) {
        const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(errno);
        rest.remove_prefix(static_cast<std::size_t>(written));
    }
    size_ += buffer_.size();
    buffer_.clear();
}

std::uint64_t OutputFile::commit() {
    flush();
    struct stat status {};
    if (fstat(descriptor_, &status) != 0) fail(errno);
    if (static_cast<std::uint64_t>(status.st_size) != size_) fail(EIO);
    if (close(std::exchange(descriptor_, -1)) != 0) fail(errno);
    if (rename(temporary_.c_str(), path_.c_str()) != 0) fail(errno);
    temporary_.clear();
    return size_;
}

void OutputFile::fail(int error) const { throw FileError(path_, "cannot write: " + reason(error)); }

}  // namespace tumble::tools
