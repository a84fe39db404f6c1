// stdio, because it reports the reason of each failure: fclose is where a full disk may show first.
#include "scene/files.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "tumble/scene.hpp"

namespace tumble::scene {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File open_file(const std::filesystem::path& file, const char* mode) {
    errno = 0;
    File handle(std::fopen(file.c_str(), mode), &std::fclose);
    if (!handle) throw FileError(file, std::strerror(errno));
    return handle;
}

}  // namespace

std::string read_file(const std::filesystem::path& file, std::size_t limit) {
    const File handle = open_file(file, "rb");
    std::string content;
    char block[1 << 16];
    errno = 0;
    while (content.size() <= limit) {
        const std::size_t count = std::fread(block, 1, sizeof block, handle.get());
        content.append(block, count);
        if (count < sizeof block) break;
    }
    if (std::ferror(handle.get()) != 0) throw FileError(file, std::strerror(errno));
    if (content.size() > limit) content.resize(limit + 1);
    return content;
}

void write_file(const std::filesystem::path& file, std::string_view content) {
    File handle = open_file(file, "wb");
    errno = 0;
    bool written = std::fwrite(content.data(), 1, content.size(), handle.get()) == content.size();
    written = std::fflush(handle.get()) == 0 && written;
    int reason = errno;
    if (std::fclose(handle.release()) != 0) {
        if (written) reason = errno;
        written = false;
    }
    if (!written) throw FileError(file, std::strerror(reason));
}

void replace_file(const std::filesystem::path& file, std::string_view content) {
    std::filesystem::path temporary = file;
    temporary += ".tmp" + std::to_string(::getpid());
    std::error_code failure;
    try {
        write_file(temporary, content);
    } catch (const FileError&) {
        std::filesystem::remove(temporary, failure);
        throw;
    }
    std::filesystem::rename(temporary, file, failure);
    if (!failure) return;
    const std::string reason = failure.message();
    std::filesystem::remove(temporary, failure);
    throw FileError(file, reason);
}

}  // namespace tumble::scene
