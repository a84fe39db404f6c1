// BMP files without compression: their rows are counted before stb reads them, which takes rows that are missing for
// black.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "render/pictures/picture_formats.hpp"
#include "render/pictures/stb_decoder.hpp"

namespace tumble::render {

namespace {

constexpr std::string_view kBmpSignature = "BM";
constexpr std::size_t kShortestFile = 30;     // a pixel after the shortest header
constexpr std::size_t kCompressionEnds = 34;  // in the longer headers

// `count` bytes, the lowest first.
std::uint32_t little_endian_at(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < count; ++i) number |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << 8 * i;
    return number;
}

struct BmpHeader {
    std::size_t pixels_at = 0;  // offset of the first row
    std::int64_t width = 0, height = 0, bits = 0;
    std::uint32_t compression = 0;
};

// Values of BmpHeader::compression. All others are compressed: runs of equal pixels, or a JPEG or PNG file inside.
constexpr std::uint32_t kNoCompression = 0, kBitFields = 3, kBitFieldsWithAlpha = 6;

// Of the first version of the format (12 bytes, numbers of 16 bits) and of those after it. A negative height means that
// the first row is the uppermost.
BmpHeader bmp_header_of(std::string_view bytes) {
    const std::size_t pixels_at = little_endian_at(bytes, 10, 4);
    if (little_endian_at(bytes, 14, 4) == 12)
        return {pixels_at, little_endian_at(bytes, 18, 2), little_endian_at(bytes, 20, 2),
                little_endian_at(bytes, 24, 2), kNoCompression};
    if (bytes.size() < kCompressionEnds) throw PictureError("the BMP file is not complete");
    const auto signed_at = [&](std::size_t at) {
        return std::int64_t{static_cast<std::int32_t>(little_endian_at(bytes, at, 4))};
    };
    return {pixels_at, signed_at(18), std::abs(signed_at(22)), little_endian_at(bytes, 28, 2),
            little_endian_at(bytes, 30, 4)};
}

bool is_compressed(const BmpHeader& header) {
    return header.compression != kNoCompression && header.compression != kBitFields &&
           header.compression != kBitFieldsWithAlpha;
}

}  // namespace

bool is_bmp(std::string_view bytes) { return bytes.starts_with(kBmpSignature); }

Image decode_bmp(std::string_view bytes) {
    if (bytes.size() < kShortestFile) throw PictureError("the BMP file is not complete");
    const BmpHeader header = bmp_header_of(bytes);
    if (is_compressed(header)) throw PictureError("the BMP file is compressed; save it as PNG, or as uncompressed BMP");
    if (std::min(header.width, header.height) < 1 || std::max(header.width, header.height) > kLargestFrame)
        throw PictureError("a side of the BMP file is not 1 to " + std::to_string(kLargestFrame) + " pixels");
    const std::int64_t row = (header.width * header.bits + 31) / 32 * 4;  // bytes, a multiple of four
    if (header.pixels_at > bytes.size() ||
        row * header.height > static_cast<std::int64_t>(bytes.size() - header.pixels_at))
        throw PictureError("the BMP file is not complete");
    return decode_by_stb(bytes, static_cast<std::size_t>(4 * header.width * header.height));
}

}  // namespace tumble::render
