// Picture files of the three formats: their pixels, whatever their names are, and files that claim more than they hold.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "render/pixels.hpp"
#include "support/temporary_folder.hpp"
#include "tumble/file.hpp"
#include "tumble/render.hpp"

using namespace tumble;
namespace fs = std::filesystem;

namespace {

fs::path seed(const std::string& name) { return fs::path(TUMBLE_SOURCE_DIR) / "tests/fuzz/seeds" / name; }

// All pictures of the seeds are 32 pixels wide, red in their left half and green in their right one.
void check_halves(const Image& image, int tolerance) {
    REQUIRE(image.width == 32);
    const auto near = [&](Color color, Color wanted) {
        return std::abs(color.r - wanted.r) <= tolerance && std::abs(color.g - wanted.g) <= tolerance &&
               std::abs(color.b - wanted.b) <= tolerance && color.a == 255;
    };
    for (int row = 0; row < image.height; ++row)
        for (const int column : {0, 7, 24, 31})
            CHECK(near(render::pixel(image, column, row), column < 16 ? Color{220, 30, 20} : Color{20, 200, 40}));
}

// A copy of the seed with its first `size` bytes.
fs::path cut_off(const TemporaryFolder& folder, const std::string& name, std::size_t size) {
    fs::path file = folder.path / name;
    std::ofstream(file, std::ios::binary) << read_file(seed(name)).substr(0, size);
    return file;
}

}  // namespace

TEST_CASE("a BMP file gives its pixels exactly, with colours or a palette, from below or from above") {
    for (const char* const name : {"picture_24.bmp", "picture_palette.bmp", "picture_top_down.bmp"}) {
        CAPTURE(name);
        check_halves(read_picture(seed(name)), 0);
    }
    // The shortest: 26 bytes of headers, and a blue pixel in a row of 4 bytes.
    const TemporaryFolder folder;
    std::ofstream(folder.path / "pixel.bmp", std::ios::binary)
        << std::string("BM\x1e\0\0\0\0\0\0\0\x1a\0\0\0\x0c\0\0\0\x01\0\x01\0\x01\0\x18\0\xff\0\0\0", 30);
    const Image image = read_picture(folder.path / "pixel.bmp");
    REQUIRE(image.width == 1);
    CHECK(render::pixel(image, 0, 0).b == 255);
    CHECK(render::pixel(image, 0, 0).r == 0);
}

TEST_CASE("a JPEG file gives its pixels, baseline or progressive") {
    // The areas are flat, so that only the steps of quantisation change them: at most 3 levels of 255 at this quality.
    for (const char* const name : {"picture_baseline.jpg", "picture_progressive.jpg"}) {
        CAPTURE(name);
        const Image image = read_picture(seed(name));
        CHECK(image.height == 16);
        check_halves(image, 3);
    }
}

TEST_CASE("the bytes and not the name decide which format a picture has") {
    const TemporaryFolder folder;
    fs::copy_file(seed("picture_24.bmp"), folder.path / "picture.png");
    check_halves(read_picture(folder.path / "picture.png"), 0);
    CHECK_THROWS_WITH_AS(read_png(folder.path / "picture.png"), doctest::Contains("picture.png: is not a PNG file"),
                         PictureError);
    std::ofstream(folder.path / "text.jpg") << "no picture";
    CHECK_THROWS_WITH_AS(read_picture(folder.path / "text.jpg"),
                         doctest::Contains("text.jpg: is not a PNG, JPEG or BMP file"), PictureError);
}

TEST_CASE("a picture that is cut off at any byte is an error") {
    const TemporaryFolder folder;
    for (const char* const name :
         {"picture_24.bmp", "picture_palette.bmp", "picture_baseline.jpg", "picture_progressive.jpg"})
        for (std::size_t size = 0; size < fs::file_size(seed(name)); size += 7) {
            CAPTURE(name);
            CAPTURE(size);
            CHECK_THROWS_AS(read_picture(cut_off(folder, name, size)), PictureError);
        }
}

TEST_CASE("a picture that claims more pixels than its bytes can hold is refused before memory is taken") {
    // 8192 by 8192 pixels in 660 bytes.
    CHECK_THROWS_WITH_AS(read_picture(seed("picture_claims_more.jpg")),
                         doctest::Contains("the JPEG file is not complete"), PictureError);
    const TemporaryFolder folder;
    CHECK_THROWS_WITH_AS(read_picture(cut_off(folder, "picture_baseline.jpg", 3)),  // before any size
                         doctest::Contains("the JPEG file is not complete"), PictureError);
    std::string bytes = read_file(seed("picture_24.bmp"));
    const auto with_sides = [&](std::string four_bytes_each) {
        std::ofstream(folder.path / "claims.bmp", std::ios::binary) << bytes.replace(18, 8, four_bytes_each);
        return folder.path / "claims.bmp";
    };
    CHECK_THROWS_WITH_AS(read_picture(with_sides({"\x00\x20\x00\x00\x00\x20\x00\x00", 8})),
                         doctest::Contains("the BMP file is not complete"), PictureError);
    CHECK_THROWS_WITH_AS(read_picture(with_sides({"\x01\x20\x00\x00\x01\x00\x00\x00", 8})),
                         doctest::Contains("is not 1 to 8192 pixels"), PictureError);
    CHECK_THROWS_WITH_AS(read_picture(with_sides({"\x01\x00\x00\x00\x00\x00\x00\x80", 8})),
                         doctest::Contains("is not 1 to 8192 pixels"), PictureError);
}

TEST_CASE("a JPEG file with arithmetic coding and a compressed BMP file are refused with a remedy") {
    const TemporaryFolder folder;
    const auto with_bytes = [&](const std::string& name, std::size_t at, const std::string& changed) {
        std::ofstream(folder.path / name, std::ios::binary)
            << read_file(seed(name)).replace(at, changed.size(), changed);
        return folder.path / name;
    };
    for (const char* const name : {"picture_baseline.jpg", "picture_progressive.jpg"}) {
        CAPTURE(name);
        const std::string bytes = read_file(seed(name));
        const bool is_baseline = bytes.find("\xff\xc0") != std::string::npos;
        const std::size_t frame = is_baseline ? bytes.find("\xff\xc0") : bytes.find("\xff\xc2");
        REQUIRE(frame != std::string::npos);
        // The kinds 9 and 10 are the sequential and the progressive frame with arithmetic coding.
        const std::string arithmetic = is_baseline ? "\xc9" : "\xca";
        CHECK_THROWS_WITH_AS(read_picture(with_bytes(name, frame + 1, arithmetic)),
                             doctest::Contains("has arithmetic coding; save it with Huffman coding, or as PNG"),
                             PictureError);
        // The mark of the start, then marks that have no length: temporary, restart 3, and a filling byte.
        const fs::path marked = folder.path / "marked.jpg";
        std::ofstream(marked, std::ios::binary) << std::string("\xff\xd8\xff\x01\xff\xd3\xff", 7)
                                                << read_file(with_bytes(name, frame + 1, arithmetic)).substr(2);
        CHECK_THROWS_WITH_AS(read_picture(marked), doctest::Contains("has arithmetic coding"), PictureError);
    }
    constexpr std::size_t kCompression = 30;  // its offset
    for (const char compression : {'\1', '\2', '\4', '\5'})
        CHECK_THROWS_WITH_AS(read_picture(with_bytes("picture_24.bmp", kCompression, {compression})),
                             doctest::Contains("the BMP file is compressed; save it as PNG"), PictureError);
}
