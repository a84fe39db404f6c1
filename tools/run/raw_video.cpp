#include "tools/run/raw_video.hpp"

#include <cstddef>

#include "tools/cli/output_path.hpp"

namespace tumble::tools {

RawVideo::RawVideo(const std::filesystem::path& file) : file_((create_folder_of(file), file)) {}

void RawVideo::write(const Image& image) {
    bytes_.clear();
    bytes_.reserve(image.rgba.size() / 4 * 3);
    for (std::size_t pixel = 0; pixel + 3 < image.rgba.size(); pixel += 4)
        for (std::size_t channel = 0; channel < 3; ++channel) bytes_ += static_cast<char>(image.rgba[pixel + channel]);
    file_.write(bytes_);
    file_.save_so_far();
}

}  // namespace tumble::tools
