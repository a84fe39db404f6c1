#include "render/output/png.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/output/base64.hpp"
#include "render/output/png_file.hpp"
#include "tumble/file.hpp"

namespace tumble {

namespace {

constexpr int kLargestSide = 16384;

void check_size(const Image& image) {
    if (image.width < 1 || image.height < 1 || image.width > kLargestSide || image.height > kLargestSide ||
        image.rgba.size() != 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))
        throw std::invalid_argument("not an image: " + std::to_string(image.width) + "x" +
                                    std::to_string(image.height) + " with " + std::to_string(image.rgba.size()) +
                                    " bytes");
}

// Frames are opaque: alpha is dropped. Writes one byte more than 3 for each pixel.
void copy_rgb(const std::uint8_t* rgba, std::size_t pixels, std::uint8_t* rgb) {
    for (std::size_t i = 0; i < pixels; ++i) std::memcpy(rgb + 3 * i, rgba + 4 * i, 4);
}

void filter_rows(const Image& image, std::vector<std::uint8_t>& rows) {
    const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
    rows.resize(height * (1 + 3 * width) + 1);
    const std::uint8_t* from = image.rgba.data();
    std::uint8_t* to = rows.data();
    for (std::size_t row = 0; row < height; ++row, from += 4 * width, to += 1 + 3 * width) {
        const bool repeats = row > 0 && std::memcmp(from, from - 4 * width, 4 * width) == 0;
        *to = repeats ? render::kFilterUp : render::kFilterNone;
        if (repeats)
            std::fill_n(to + 1, 3 * width, std::uint8_t{0});
        else
            copy_rgb(from, width, to + 1);
    }
    rows.pop_back();
}

}  // namespace

std::string to_png(const Image& image) {
    check_size(image);
    thread_local std::vector<std::uint8_t> rows;
    filter_rows(image, rows);
    return render::make_png(image.width, image.height, render::PngPixels::rgb8, rows);
}

std::string png_data_url(const Image& image) { return "data:image/png;base64," + render::base64(to_png(image)); }

std::uint64_t render::write_png_file(const Image& image, const std::filesystem::path& file) {
    const std::string png = to_png(image);
    OutputFile output(file);
    output.write(png);
    return output.commit();
}

void write_png(const Image& image, const std::filesystem::path& file) { render::write_png_file(image, file); }

}  // namespace tumble
