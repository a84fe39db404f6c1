#include "render/pictures/stb_decoder.hpp"

#include <cstdint>
#include <cstdlib>
#include <memory>

namespace {

// The most bytes of one block of memory of stb for the picture being read.
thread_local std::size_t most_bytes_of_block = 0;

}  // namespace

#define STBI_MALLOC(size) (static_cast<std::size_t>(size) <= most_bytes_of_block ? std::malloc(size) : nullptr)
#define STBI_REALLOC(block, size) \
    (static_cast<std::size_t>(size) <= most_bytes_of_block ? std::realloc(block, size) : nullptr)
#define STBI_FREE(block) std::free(block)

// Not more than a frame of the largest size: stb refuses larger sides before it takes memory. Its JPEG decoder is left
// out: that of Debian 12 reads beyond its tables if a file is damaged (CVE-2022-28042).
#ifndef __clang_analyzer__  // it would report what it finds in stb
#define STB_IMAGE_IMPLEMENTATION
#endif
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_BMP
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

namespace tumble::render {

static_assert(kLargestFrame == STBI_MAX_DIMENSIONS);

Image decode_by_stb(std::string_view bytes, std::size_t most_bytes) {
    most_bytes_of_block = most_bytes;
    Image image;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                              &image.width, &image.height, nullptr, 4),
        &stbi_image_free);
    if (!pixels) throw PictureError(stbi_failure_reason());
    const std::size_t size = 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.rgba.assign(pixels.get(), pixels.get() + size);
    return image;
}

}  // namespace tumble::render
