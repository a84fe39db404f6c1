// Reads PNG files.
#pragma once

#include <filesystem>

#include "tumble/render.hpp"

namespace tumble::tools {

// Throws FileError if the file cannot be read, InputError if it is no PNG file or larger than kLargestFrame a side.
Image read_png(const std::filesystem::path& file);

}  // namespace tumble::tools
