#include "render/output/png_file.hpp"

#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

#include <memory>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "debug/check.hpp"

namespace tumble::render {

namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";

void append_big_endian(std::string& bytes, std::uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
}

// Length, type, data and checksum of type and data.
void append_chunk(std::string& png, std::string_view type, std::string_view data) {
    append_big_endian(png, static_cast<std::uint32_t>(data.size()));
    const std::size_t start = png.size();
    png += type;
    png += data;
    const auto* const bytes = reinterpret_cast<const unsigned char*>(png.data()) + start;
    append_big_endian(png, crc32_gzip_refl(0, bytes, png.size() - start));
}

// Memory of one thread, which its next file uses again.
struct Compressor {
    isal_zstream stream;
    std::uint8_t level_buffer[ISAL_DEF_LVL1_DEFAULT];
    std::vector<std::uint8_t> out;
};

// As zlib writes it [RFC 1950]. The result lasts until the thread compresses again.
std::string_view compressed(std::span<const std::uint8_t> bytes) {
    thread_local const std::unique_ptr<Compressor> own = std::make_unique<Compressor>();
    isal_zstream& stream = own->stream;
    // Bytes that do not compress are stored in blocks of 65535 with headers of 5 bytes.
    own->out.resize(bytes.size() + 5 * (bytes.size() / 65535 + 1) + 64);
    isal_deflate_stateless_init(&stream);
    stream.level = 1;
    stream.level_buf = own->level_buffer;
    stream.level_buf_size = sizeof own->level_buffer;
    stream.gzip_flag = IGZIP_ZLIB;
    stream.end_of_stream = 1;
    stream.next_in = const_cast<std::uint8_t*>(bytes.data());
    stream.avail_in = static_cast<std::uint32_t>(bytes.size());
    stream.next_out = own->out.data();
    stream.avail_out = static_cast<std::uint32_t>(own->out.size());
    if (isal_deflate_stateless(&stream) != COMP_OK) throw std::logic_error("the compressor of PNG files failed");
    TUMBLE_CHECK(stream.avail_in == 0);
    return {reinterpret_cast<const char*>(own->out.data()), stream.total_out};
}

// Bits of a channel and type of colour; then deflate, five filters, not interlaced.
std::string_view format_of(PngPixels pixels) {
    using namespace std::string_view_literals;
    return pixels == PngPixels::grey16 ? "\x10\0\0\0\0"sv : "\x08\x02\0\0\0"sv;
}

}  // namespace

std::string make_png(int width, int height, PngPixels pixels, std::span<const std::uint8_t> rows) {
    std::string header;
    append_big_endian(header, static_cast<std::uint32_t>(width));
    append_big_endian(header, static_cast<std::uint32_t>(height));
    header += format_of(pixels);
    std::string png(kSignature);
    append_chunk(png, "IHDR", header);
    append_chunk(png, "IDAT", compressed(rows));
    append_chunk(png, "IEND", {});
    return png;
}

}  // namespace tumble::render
