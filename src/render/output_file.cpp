#include "render/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>

#include "tumble/scene.hpp"

namespace tumble::render {
namespace {

// A name that no other thread or process uses.
std::filesystem::path temporary_name(const std::filesystem::path& file) {
    static std::atomic<unsigned> serial{0};
    std::filesystem::path name = file;
    name += ".part-" + std::to_string(getpid()) + "-" + std::to_string(serial++);
    return name;
}

// Writes all bytes; the error number, or 0.
int write_all(int descriptor, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return written < 0 ? errno : EIO;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return 0;
}

[[noreturn]] void fail(const std::filesystem::path& file, int error) {
    throw FileError(file, std::generic_category().message(error));
}

}  // namespace

void write_file(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
    const std::filesystem::path temporary = temporary_name(file);
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) fail(file, errno);
    int error = write_all(descriptor, bytes);
    // Some file systems report a full disk only here.
    if (::close(descriptor) != 0 && error == 0) error = errno;
    if (error == 0 && ::rename(temporary.c_str(), file.c_str()) != 0) error = errno;
    if (error == 0) return;
    ::unlink(temporary.c_str());
    fail(file, error);
}

}  // namespace tumble::render
