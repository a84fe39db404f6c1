// JPEG files, decoded by libjpeg-turbo.
#include <turbojpeg.h>

#include <algorithm>
#include <memory>
#include <string>
#include <type_traits>

#include "render/pictures/picture_formats.hpp"

namespace tumble::render {

namespace {

constexpr std::string_view kJpegSignature = "\xff\xd8\xff";

// The first scan has at least one bit for each block of 8 by 8 pixels: a file that claims more pixels is not complete.
constexpr std::size_t kMostPixelsOfByte = std::size_t{8} * 8 * 8;

using JpegDecoder = std::unique_ptr<std::remove_pointer_t<tjhandle>, int (*)(tjhandle)>;

const unsigned char* jpeg_data_of(std::string_view bytes) {
    return reinterpret_cast<const unsigned char*>(bytes.data());
}

// Whether the frame header says that arithmetic coding packs the pixels. A segment before it begins with 0xff, its
// kind, and its length without these two bytes; a segment without content has no length. False for a file that ends or
// is damaged before its frame header.
bool has_arithmetic_coding(std::string_view bytes) {
    constexpr int kFirstFrame = 0xc0, kLastFrame = 0xcf, kFirstArithmeticFrame = 0xc9;
    constexpr int kTables = 0xc4, kExtension = 0xc8,
                  kArithmeticTables = 0xcc;  // no frames, in the range of their kinds
    constexpr int kTemporary = 0x01, kFirstRestart = 0xd0, kLastRestart = 0xd7;  // without content
    const auto byte_at = [&](std::size_t at) { return int{static_cast<unsigned char>(bytes[at])}; };
    std::size_t at = 2;  // after the mark of the start
    while (at + 4 <= bytes.size() && byte_at(at) == 0xff) {
        const int kind = byte_at(at + 1);
        if (kind == 0xff) {  // a filling byte
            ++at;
            continue;
        }
        const bool is_frame = kind >= kFirstFrame && kind <= kLastFrame && kind != kTables && kind != kExtension &&
                              kind != kArithmeticTables;
        if (is_frame) return kind >= kFirstArithmeticFrame;
        const bool is_empty = kind == kTemporary || (kind >= kFirstRestart && kind <= kLastRestart);
        at += 2 + (is_empty ? 0 : static_cast<std::size_t>(256 * byte_at(at + 2) + byte_at(at + 3)));
    }
    return false;
}

// An image of the size that the file claims, with no pixels yet.
Image read_jpeg_header(tjhandle decoder, std::string_view bytes) {
    Image image;
    int subsampling = 0, color_space = 0;
    if (tjDecompressHeader3(decoder, jpeg_data_of(bytes), bytes.size(), &image.width, &image.height, &subsampling,
                            &color_space) != 0)
        throw PictureError(tjGetErrorStr2(decoder));
    if (std::min(image.width, image.height) < 1) throw PictureError("the JPEG file is not complete");  // tables alone
    if (std::max(image.width, image.height) > kLargestFrame)
        throw PictureError("a side of the JPEG file has more than " + std::to_string(kLargestFrame) + " pixels");
    return image;
}

}  // namespace

bool is_jpeg(std::string_view bytes) { return bytes.starts_with(kJpegSignature); }

// A file with arithmetic coding is refused, because it may hold any number of pixels in a byte. A warning is an error,
// as a file that is cut off gives one. libjpeg-turbo refuses more than 500 scans, each of which would go through all
// pixels.
Image decode_jpeg(std::string_view bytes) {
    if (has_arithmetic_coding(bytes))
        throw PictureError("the JPEG file has arithmetic coding; save it with Huffman coding, or as PNG");
    const JpegDecoder decoder(tjInitDecompress(), &tjDestroy);
    if (!decoder) throw PictureError(tjGetErrorStr2(nullptr));
    Image image = read_jpeg_header(decoder.get(), bytes);
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (pixels > kMostPixelsOfByte * bytes.size()) throw PictureError("the JPEG file is not complete");
    image.rgba.resize(4 * pixels);
    if (tjDecompress2(decoder.get(), jpeg_data_of(bytes), bytes.size(), image.rgba.data(), image.width, 0, image.height,
                      TJPF_RGBA, TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS | TJFLAG_ACCURATEDCT) != 0)
        throw PictureError(tjGetErrorStr2(decoder.get()));
    return image;
}

}  // namespace tumble::render
