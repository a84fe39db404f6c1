#include "tools/output/image_grid.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tumble::tools {

namespace {

constexpr Color kWhite{255, 255, 255};

std::size_t offset_of(const Image& image, int x, int y) {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
}

Image filled(int width, int height, Color color) {
    Image image{width, height, {}};
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    image.rgba.reserve(4 * pixels);
    for (std::size_t i = 0; i < pixels; ++i)
        for (const std::uint8_t channel : {color.r, color.g, color.b, color.a}) image.rgba.push_back(channel);
    return image;
}

void paste(Image& target, const Image& image, int left, int top) {
    for (int row = 0; row < image.height; ++row) {
        const auto from = image.rgba.begin() + static_cast<std::ptrdiff_t>(offset_of(image, 0, row));
        std::copy_n(from, 4 * static_cast<std::ptrdiff_t>(image.width),
                    target.rgba.begin() + static_cast<std::ptrdiff_t>(offset_of(target, left, top + row)));
    }
}

}  // namespace

Image image_grid(std::span<const Image> images, int columns, int gap, Color behind) {
    const int count = static_cast<int>(images.size());
    const int across = std::min(columns, count), rows = (count + columns - 1) / columns;
    int width = 0, height = 0;
    for (const Image& image : images) {
        width = std::max(width, image.width);
        height = std::max(height, image.height);
    }
    Image grid = filled(across * width + (across - 1) * gap, rows * height + (rows - 1) * gap, behind);
    for (int i = 0; i < count; ++i)
        paste(grid, images[static_cast<std::size_t>(i)], i % columns * (width + gap), i / columns * (height + gap));
    return grid;
}

Image stacked(const Image& above, const Image& below) {
    Image whole = filled(std::max(above.width, below.width), above.height + below.height, kWhite);
    paste(whole, above, 0, 0);
    paste(whole, below, 0, above.height);
    return whole;
}

Image mean_of(const Image& a, const Image& b) {
    Image mean = a;
    for (std::size_t i = 0; i < mean.rgba.size(); ++i)
        mean.rgba[i] = static_cast<std::uint8_t>((a.rgba[i] + b.rgba[i] + 1) / 2);
    return mean;
}

void paint_column(Image& image, int x, int top, int bottom, Color color) {
    if (x < 0 || x >= image.width) return;
    for (int y = std::max(top, 0); y < std::min(bottom, image.height); ++y) {
        const std::size_t at = offset_of(image, x, y);
        image.rgba[at] = color.r;
        image.rgba[at + 1] = color.g;
        image.rgba[at + 2] = color.b;
    }
}

}  // namespace tumble::tools
