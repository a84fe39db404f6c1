// PNG files from outside: their chunks are checked before stb reads them.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "tumble/file.hpp"
#include "tumble/render.hpp"

namespace {

// The most bytes of one block of memory of stb for the picture being read. stb doubles the block of the decompressed
// data, whatever the size of the picture is, so that data that decompress to more than the picture needs are an error.
thread_local std::size_t most_bytes = 0;

}  // namespace

#define STBI_MALLOC(size) (static_cast<std::size_t>(size) <= most_bytes ? std::malloc(size) : nullptr)
#define STBI_REALLOC(block, size) (static_cast<std::size_t>(size) <= most_bytes ? std::realloc(block, size) : nullptr)
#define STBI_FREE(block) std::free(block)

// Not more than a frame of the largest size: stb refuses larger sides before it takes memory.
#ifndef __clang_analyzer__  // it would report what it finds in stb
#define STB_IMAGE_IMPLEMENTATION
#endif
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_MAX_DIMENSIONS 8192
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#ifdef __clang__  // an empty first IDAT makes stb copy no bytes to a null pointer, which UBSan reports
#pragma clang attribute push(__attribute__((no_sanitize("nonnull-attribute"))), apply_to = function)
#endif
#include <stb_image.h>
#ifdef __clang__
#pragma clang attribute pop
#endif
#pragma GCC diagnostic pop

namespace tumble {

static_assert(kLargestFrame == STBI_MAX_DIMENSIONS);

namespace {

// Four bytes, the highest first.
std::size_t number_at(std::string_view bytes, std::size_t at) {
    std::size_t number = 0;
    for (const char digit : bytes.substr(at, 4)) number = number << 8 | static_cast<unsigned char>(digit);
    return number;
}

// Of the first chunk, IHDR (PNG, 11.2.2); 0 for sides that stb refuses.
std::size_t pixels_of_header(std::string_view bytes) {
    if (bytes.size() < 24) return 0;
    const std::size_t width = number_at(bytes, 16), height = number_at(bytes, 20);
    return std::max(width, height) > kLargestFrame ? 0 : width * height;
}

// A pixel has at most 8 bytes, of which a doubled block has 16; the 1 MiB is for the filter byte of each row. The
// compressed data are at most the file, in a doubled block.
std::size_t most_bytes_of(std::string_view bytes) {
    return std::max(16 * pixels_of_header(bytes) + (std::size_t{1} << 20), 2 * bytes.size());
}

// Whether the file holds all bytes of each chunk up to its end (PNG, 5.3): stb takes memory for as many as a chunk
// claims.
bool holds_its_chunks(std::string_view bytes) {
    constexpr std::size_t kAround = 12;  // length, type and checksum
    std::size_t at = 8;                  // after the signature
    while (at <= bytes.size() && bytes.size() - at >= kAround) {
        const std::size_t length = number_at(bytes, at);
        if (length > bytes.size() - at - kAround) return false;
        if (bytes.substr(at + 4, 4) == "IEND") return true;
        at += kAround + length;
    }
    return false;
}

}  // namespace

Image read_png(const std::filesystem::path& file) {
    constexpr std::size_t kMaxBytes = std::size_t{1} << 29;  // more than the pixels of the largest frame
    const std::string bytes = read_file(file, kMaxBytes);
    if (bytes.size() > kMaxBytes) throw PictureError(file.string() + ": the picture is too large");
    if (!holds_its_chunks(bytes)) throw PictureError(file.string() + ": is not a PNG file, or not complete");
    most_bytes = most_bytes_of(bytes);
    Image image;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                              &image.width, &image.height, nullptr, 4),
        &stbi_image_free);
    if (!pixels) throw PictureError(file.string() + ": is not a valid PNG file: " + stbi_failure_reason());
    const std::size_t size = 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.rgba.assign(pixels.get(), pixels.get() + size);
    return image;
}

}  // namespace tumble
