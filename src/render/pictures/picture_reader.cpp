// Picture files from outside, in the formats that picture_formats.hpp decodes.
#include <filesystem>
#include <string>
#include <system_error>

#include "render/pictures/picture_formats.hpp"
#include "tumble/file.hpp"
#include "tumble/render.hpp"

namespace tumble {

namespace {

std::string read_picture_bytes(const std::filesystem::path& file) {
    constexpr std::size_t kMaxBytes = std::size_t{1} << 29;  // more than the pixels of the largest frame
    std::error_code ignored;
    if (std::filesystem::is_other(file, ignored)) throw PictureError("is a pipe or a device, no file");
    std::string bytes = read_file(file, kMaxBytes);
    if (bytes.size() > kMaxBytes) throw PictureError("the picture is too large");
    return bytes;
}

Image decode_any(const std::string& bytes) {
    if (render::is_png(bytes)) return render::decode_png(bytes);
    if (render::is_jpeg(bytes)) return render::decode_jpeg(bytes);
    if (render::is_bmp(bytes)) return render::decode_bmp(bytes);
    throw PictureError("is not a PNG, JPEG or BMP file");
}

Image decode_only_png(const std::string& bytes) {
    if (!render::is_png(bytes)) throw PictureError("is not a PNG file");
    return render::decode_png(bytes);
}

// Names the file in the message of an error.
template <class Decode>
Image read_by(const std::filesystem::path& file, Decode decode_bytes) {
    try {
        return decode_bytes(read_picture_bytes(file));
    } catch (const PictureError& error) {
        throw PictureError(file.string() + ": " + error.what());
    }
}

}  // namespace

Image read_png(const std::filesystem::path& file) { return read_by(file, decode_only_png); }
Image read_picture(const std::filesystem::path& file) { return read_by(file, decode_any); }

}  // namespace tumble
