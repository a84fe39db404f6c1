// PNG files: their chunks are checked before stb reads them.
#include <algorithm>

#include "render/pictures/picture_formats.hpp"
#include "render/pictures/stb_decoder.hpp"

namespace tumble::render {

namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

// Four bytes, the highest first.
std::size_t big_endian_at(std::string_view bytes, std::size_t at) {
    std::size_t number = 0;
    for (const char digit : bytes.substr(at, 4)) number = number << 8 | static_cast<unsigned char>(digit);
    return number;
}

// Of the first chunk, IHDR (PNG, 11.2.2); 0 for sides that stb refuses.
std::size_t pixels_of_header(std::string_view bytes) {
    if (bytes.size() < 24) return 0;
    const std::size_t width = big_endian_at(bytes, 16), height = big_endian_at(bytes, 20);
    return std::max(width, height) > kLargestFrame ? 0 : width * height;
}

// A pixel has at most 8 bytes. stb doubles the block of the decompressed data, whatever the size of the picture is; the
// 1 MiB is for the filter byte of each row. The compressed data are at most the file, in a doubled block.
std::size_t most_bytes_of(std::string_view bytes) {
    return std::max(16 * pixels_of_header(bytes) + (std::size_t{1} << 20), 2 * bytes.size());
}

// Whether the file holds all bytes of each chunk up to its end (PNG, 5.3): stb takes memory for as many as a chunk
// claims.
bool holds_its_chunks(std::string_view bytes) {
    constexpr std::size_t kAround = 12;  // length, type and checksum
    std::size_t at = kPngSignature.size();
    while (at <= bytes.size() && bytes.size() - at >= kAround) {
        const std::size_t length = big_endian_at(bytes, at);
        if (length > bytes.size() - at - kAround) return false;
        if (bytes.substr(at + 4, 4) == "IEND") return true;
        at += kAround + length;
    }
    return false;
}

}  // namespace

bool is_png(std::string_view bytes) { return bytes.starts_with(kPngSignature); }

Image decode_png(std::string_view bytes) {
    if (!holds_its_chunks(bytes)) throw PictureError("the PNG file is not complete");
    return decode_by_stb(bytes, most_bytes_of(bytes));
}

}  // namespace tumble::render
