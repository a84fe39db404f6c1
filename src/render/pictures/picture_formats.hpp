// The formats of pictures from outside. Each decoder compares what a file claims with what it holds before it takes
// memory, and throws PictureError with the reason alone, for a file that is damaged or has a side of more than
// kLargestFrame pixels.
#pragma once

#include <string_view>

#include "tumble/render.hpp"

namespace tumble::render {

bool is_png(std::string_view bytes);
Image decode_png(std::string_view bytes);

bool is_jpeg(std::string_view bytes);
Image decode_jpeg(std::string_view bytes);

bool is_bmp(std::string_view bytes);
Image decode_bmp(std::string_view bytes);

}  // namespace tumble::render
