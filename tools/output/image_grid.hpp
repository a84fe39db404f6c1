// Images beside and below each other as one image.
#pragma once

#include <span>

#include "tumble/render.hpp"

namespace tumble::tools {

// The images row by row, `columns` of them in a row, each in a cell of the size of the largest, with gaps (px) between
// the cells. `behind` is the colour of what the images do not cover. At least one image.
Image image_grid(std::span<const Image> images, int columns, int gap, Color behind);

// One image above another, from the left.
Image stacked(const Image& above, const Image& below);

// The mean of two images of one size.
Image mean_of(const Image& a, const Image& b);

// Paints a column of pixels, if the image has it.
void paint_column(Image& image, int x, int top, int bottom, Color color);

}  // namespace tumble::tools
