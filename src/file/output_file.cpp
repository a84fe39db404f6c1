// System calls instead of streams: they report the reason of a failure. Some file systems report a full disk only at
// close().
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include "tumble/file.hpp"

namespace tumble {

namespace {

constexpr std::size_t kBufferSize = 1 << 16;  // bytes: large enough that the cost of a system call is negligible

// A name that no other thread or running process uses.
std::filesystem::path temporary_name(const std::filesystem::path& file) {
    static std::atomic<unsigned> serial{0};
    std::filesystem::path name = file;
    name += "." + std::to_string(::getpid()) + "-" + std::to_string(serial++) + ".partial";
    return name;
}

}  // namespace

FileError::FileError(const std::filesystem::path& path, std::string_view reason)
    : std::runtime_error(path.string() + ": " + std::string(reason)) {}

OutputFile::OutputFile(std::filesystem::path file) : path_(std::move(file)) {
    if (path_ == "/dev/stdout") {
        descriptor_ = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
        if (descriptor_ < 0) fail(errno);
        return;
    }
    // A killed process may have left a file of this name: the system gives its number to another process later.
    do {
        temporary_ = temporary_name(path_);
        descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) fail(errno);
    ::flock(descriptor_, LOCK_EX);  // for find_partial_files(), which does without it where it fails
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_),
      buffer_(std::move(other.buffer_)) {}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::write(std::string_view bytes) {
    buffer_ += bytes;
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

std::uint64_t OutputFile::save_so_far() {
    flush();
    return size_;
}

void OutputFile::leave() {
    temporary_.clear();
    ::close(std::exchange(descriptor_, -1));
}

void OutputFile::append_from(const std::filesystem::path& file, std::uint64_t begin, std::uint64_t end) {
    std::ifstream stream(file, std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(begin));
    std::string block(kBufferSize, '\0');
    for (std::uint64_t at = begin; at < end;) {
        const std::uint64_t count = std::min<std::uint64_t>(block.size(), end - at);
        if (!stream.read(block.data(), static_cast<std::streamsize>(count)))
            throw FileError(file, "cannot read " + std::to_string(end) + " bytes of it");
        write(std::string_view(block).substr(0, count));
        at += count;
    }
}

void OutputFile::take_from_others() {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) fail(errno);
    size_ = static_cast<std::uint64_t>(status.st_size);
    buffer_.clear();
}

std::uint64_t OutputFile::commit() {
    flush();
    const bool is_stream = temporary_.empty();
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) fail(errno);
    if (!is_stream && static_cast<std::uint64_t>(status.st_size) != size_) fail(EIO);
    if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
    if (is_stream) return size_;
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail(errno);
    temporary_.clear();
    return size_;
}

void OutputFile::fail(int error) const {
    throw FileError(temporary_.empty() ? "standard output" : path_,
                    "cannot write: " + std::generic_category().message(error));
}

}  // namespace tumble
