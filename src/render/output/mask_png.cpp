// Masks as PNG files: one channel, 16 bits. stb writes 8 bits only.
//
// A row is filtered by the row above (filter 2), so that equal rows become zeros, which compress to a few bytes.
#include <libdeflate.h>

#include <array>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "render/output/compressor.hpp"
#include "tumble/file.hpp"
#include "tumble/recording.hpp"

namespace tumble {
namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";
constexpr unsigned char kFilterUp = 2;

void append_big_endian(std::string& bytes, std::uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
}

// Length, type, data and checksum of type and data.
void append_chunk(std::string& png, const std::string& type, std::string_view data) {
    append_big_endian(png, static_cast<std::uint32_t>(data.size()));
    const std::size_t start = png.size();
    png += type;
    png += data;
    append_big_endian(png, libdeflate_crc32(0, png.data() + start, png.size() - start));
}

std::string filtered_rows(const Mask& mask) {
    const auto width = static_cast<std::size_t>(mask.width), height = static_cast<std::size_t>(mask.height);
    std::string rows;
    rows.reserve(height * (2 * width + 1));
    for (std::size_t row = 0; row < height; ++row) {
        rows += static_cast<char>(kFilterUp);
        for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
            const unsigned label = mask.labels[i], above = row > 0 ? mask.labels[i - width] : 0u;
            rows += static_cast<char>(((label >> 8) - (above >> 8)) & 0xff);
            rows += static_cast<char>((label - above) & 0xff);
        }
    }
    return rows;
}

std::string zlib_compressed(const std::string& bytes) {
    constexpr int kLevel = 4;
    const render::Compressor compressor(libdeflate_alloc_compressor(kLevel));
    if (!compressor) throw std::bad_alloc();
    std::string out(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
    out.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), out.data(), out.size()));
    return out;
}

}  // namespace

std::string to_png(const Mask& mask) {
    std::string header;
    append_big_endian(header, static_cast<std::uint32_t>(mask.width));
    append_big_endian(header, static_cast<std::uint32_t>(mask.height));
    header += std::string("\x10\0\0\0\0", 5);  // 16 bits, grey; deflate, five filters, not interlaced
    std::string png(kPngSignature);
    append_chunk(png, "IHDR", header);
    append_chunk(png, "IDAT", zlib_compressed(filtered_rows(mask)));
    append_chunk(png, "IEND", {});
    return png;
}

std::uint64_t write_mask_png(const Mask& mask, const std::filesystem::path& file) {
    OutputFile output(file);
    output.write(to_png(mask));
    return output.commit();
}

}  // namespace tumble
