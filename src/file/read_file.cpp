// C streams, as they report the reason of a failure in errno.
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "tumble/file.hpp"

namespace tumble {

std::string read_file(const std::filesystem::path& file, std::size_t limit) {
    const auto fail = [&file] {
        const int reason = errno;
        throw FileError(file,
                        std::generic_category().message(reason) + (reason == EISDIR ? "; name a file in it" : ""));
    };
    errno = 0;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> handle(std::fopen(file.c_str(), "rb"), &std::fclose);
    if (!handle) fail();
    std::string content;
    char block[1 << 16];
    while (content.size() <= limit) {
        const std::size_t count = std::fread(block, 1, sizeof block, handle.get());
        content.append(block, count);
        if (count < sizeof block) break;
    }
    if (std::ferror(handle.get()) != 0) fail();
    if (content.size() > limit) content.resize(limit + 1);
    return content;
}

}  // namespace tumble
