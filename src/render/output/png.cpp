#include "render/output/png.hpp"

#include <libdeflate.h>

#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "debug/check.hpp"
#include "render/output/base64.hpp"
#include "render/output/compressor.hpp"
#include "tumble/file.hpp"

namespace {

// The compressor that stb calls. Returns null if memory is short, which stb then returns to encode_png().
unsigned char* compress_fast(unsigned char* data, int size, int* compressed_size, int /*quality*/) {
    constexpr int kLevel = 1;
    thread_local const tumble::render::Compressor compressor(libdeflate_alloc_compressor(kLevel));
    if (!compressor) return nullptr;
    const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), static_cast<std::size_t>(size));
    auto* const out = static_cast<unsigned char*>(std::malloc(bound));
    if (!out) return nullptr;
    *compressed_size =
        static_cast<int>(libdeflate_zlib_compress(compressor.get(), data, static_cast<std::size_t>(size), out, bound));
    TUMBLE_CHECK(*compressed_size > 0);
    return out;
}

}  // namespace

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBIW_ZLIB_COMPRESS compress_fast
#include <stb_image_write.h>

namespace tumble {
namespace render {
namespace {

// stb's settings are globals. A static initialiser sets them once, before any thread encodes.
void configure_stb_once() {
    static const bool configured = [] {
        stbi_write_force_png_filter = 0;
        return true;
    }();
    static_cast<void>(configured);
}

// Frames are opaque: alpha is dropped.
void copy_rgb(const Image& image, std::vector<std::uint8_t>& rgb) {
    const std::size_t pixels = image.rgba.size() / 4;
    rgb.resize(3 * pixels);
    const std::uint8_t* from = image.rgba.data();
    std::uint8_t* to = rgb.data();
    for (std::size_t i = 0; i < pixels; ++i, from += 4, to += 3) {
        to[0] = from[0];
        to[1] = from[1];
        to[2] = from[2];
    }
}

}  // namespace

void PngBytes::Free::operator()(std::uint8_t* data) const { std::free(data); }

PngBytes encode_png(const Image& image) {
    constexpr int kLargestSide = 16384;  // stb counts bytes in int
    if (image.width < 1 || image.height < 1 || image.width > kLargestSide || image.height > kLargestSide ||
        image.rgba.size() != 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))
        throw std::invalid_argument("not an image: " + std::to_string(image.width) + "x" +
                                    std::to_string(image.height) + " with " + std::to_string(image.rgba.size()) +
                                    " bytes");
    configure_stb_once();
    thread_local std::vector<std::uint8_t> rgb;
    copy_rgb(image, rgb);
    int size = 0;
    unsigned char* const data = stbi_write_png_to_mem(rgb.data(), 3 * image.width, image.width, image.height, 3, &size);
    if (!data) throw std::bad_alloc();
    return {data, static_cast<std::size_t>(size)};
}

std::uint64_t write_png_file(const Image& image, const std::filesystem::path& file) {
    const PngBytes png = encode_png(image);
    OutputFile output(file);
    output.write({reinterpret_cast<const char*>(png.bytes().data()), png.bytes().size()});
    return output.commit();
}

}  // namespace render

std::string to_png(const Image& image) {
    const render::PngBytes png = render::encode_png(image);
    return {png.bytes().begin(), png.bytes().end()};
}

std::string png_data_url(const Image& image) { return "data:image/png;base64," + render::base64(to_png(image)); }

void write_png(const Image& image, const std::filesystem::path& file) { render::write_png_file(image, file); }

}  // namespace tumble
