// Encodes images as PNG: RGB. A row that equals the one above it is stored as differences, which are all zero: frames
// are mostly flat colour.
#pragma once

#include <cstdint>
#include <filesystem>

#include "tumble/render.hpp"

namespace tumble::render {

// Encodes and writes; returns the size of the file. Throws as to_png(), and FileError.
std::uint64_t write_png_file(const Image& image, const std::filesystem::path& file);

}  // namespace tumble::render
