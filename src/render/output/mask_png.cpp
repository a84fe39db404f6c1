// Masks as PNG files: one channel, 16 bits. All rows are stored as differences from the row above, so that equal rows
// become zeros.
#include <string>
#include <vector>

#include "render/output/png_file.hpp"
#include "tumble/file.hpp"
#include "tumble/recording.hpp"

namespace tumble {
namespace {

std::vector<std::uint8_t> filtered_rows(const Mask& mask) {
    const auto width = static_cast<std::size_t>(mask.width), height = static_cast<std::size_t>(mask.height);
    std::vector<std::uint8_t> rows;
    rows.reserve(height * (2 * width + 1));
    for (std::size_t row = 0; row < height; ++row) {
        rows.push_back(render::kFilterUp);
        for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
            const unsigned label = mask.labels[i], above = row > 0 ? mask.labels[i - width] : 0u;
            rows.push_back(static_cast<std::uint8_t>((label >> 8) - (above >> 8)));
            rows.push_back(static_cast<std::uint8_t>(label - above));
        }
    }
    return rows;
}

}  // namespace

std::string to_png(const Mask& mask) {
    return render::make_png(mask.width, mask.height, render::PngPixels::grey16, filtered_rows(mask));
}

std::uint64_t write_mask_png(const Mask& mask, const std::filesystem::path& file) {
    OutputFile output(file);
    output.write(to_png(mask));
    return output.commit();
}

}  // namespace tumble
