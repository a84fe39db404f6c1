// Encodes images as PNG: RGB, no filter, fast compression. Frames are mostly flat colour; on them this takes a ninth of
// the time of stb's own compressor and gives smaller files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "tumble/render.hpp"

namespace tumble::render {

// The bytes of a PNG file; owns memory of std::malloc.
class PngBytes {
public:
    PngBytes(std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

    std::span<const std::uint8_t> bytes() const { return {data_.get(), size_}; }

private:
    struct Free {
        void operator()(std::uint8_t* data) const;
    };
    std::unique_ptr<std::uint8_t, Free> data_;
    std::size_t size_;
};

// May run on several threads at once. Throws std::invalid_argument for an image whose buffer does not fit its size.
PngBytes encode_png(const Image& image);

// Encodes and writes; returns the size of the file.
std::uint64_t write_png_file(const Image& image, const std::filesystem::path& file);

}  // namespace tumble::render
