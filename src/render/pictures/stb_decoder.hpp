// The decoders of stb, PNG and BMP. They are to be called with checked files only.
#pragma once

#include <cstddef>
#include <string_view>

#include "tumble/render.hpp"

namespace tumble::render {

// `most_bytes` bounds each block of memory that stb takes, so that data that decompress to more than the picture needs
// are an error. Throws PictureError with stb's reason.
Image decode_by_stb(std::string_view bytes, std::size_t most_bytes);

}  // namespace tumble::render
