// PNG files: they decode to the image, repeat byte for byte, and a failure leaves no file.
#include "render/output/png.hpp"

#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <vector>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb_image.h>

#include "support/small_disk.hpp"
#include "support/temporary_folder.hpp"
#include "tumble/file.hpp"
#include "tumble/recording.hpp"

using namespace tumble;

namespace {

Image test_image(int width, int height) {
    Image image{width, height, {}};
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            for (const int value : {column * 7, row * 5, column ^ row, 255})
                image.rgba.push_back(static_cast<std::uint8_t>(value));
    return image;
}

// Pixels that do not compress, in rows of which every third repeats the one above.
Image noise_image(int width, int height) {
    Image image{width, height, {}};
    std::mt19937 generator(7);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < 4 * width; ++column) {
            const std::size_t above = image.rgba.size() - 4 * static_cast<std::size_t>(width);
            const auto value = static_cast<std::uint8_t>(generator());
            image.rgba.push_back(column % 4 == 3 ? 255 : row % 3 == 2 ? image.rgba[above] : value);
        }
    return image;
}

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t file_count(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

std::string message_of_failed_write(const Image& image, const std::filesystem::path& file) {
    try {
        write_png(image, file);
    } catch (const FileError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("a PNG file decodes to the image") {
    const TemporaryFolder folder;
    const Image images[] = {test_image(1, 1), test_image(33, 7), test_image(320, 180), noise_image(1, 3),
                            noise_image(640, 359)};
    for (const Image& image : images) {
        write_png(image, folder.path / "frame.png");
        int read_width = 0, read_height = 0, channels = 0;
        const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
            stbi_load((folder.path / "frame.png").c_str(), &read_width, &read_height, &channels, 4), &stbi_image_free);
        REQUIRE(pixels);
        CHECK(read_width == image.width);
        CHECK(read_height == image.height);
        CHECK(channels == 3);
        CHECK(std::equal(image.rgba.begin(), image.rgba.end(), pixels.get()));
    }
    CHECK(file_count(folder.path) == 1);  // the last replaced those before, and no temporary file is left
}

TEST_CASE("data that decompress to far more than the pixels of a picture are an error") {
    // One pixel, with 8 MiB of zeros for its four bytes.
    CHECK_THROWS_AS(read_png(std::filesystem::path(TUMBLE_SOURCE_DIR) / "tests/fuzz/seeds/picture_bomb.png"),
                    PictureError);
}

TEST_CASE("the same image gives the same bytes") {
    const TemporaryFolder folder;
    const Image image = test_image(200, 100);
    write_png(image, folder.path / "a.png");
    write_png(test_image(10, 10), folder.path / "between.png");
    write_png(image, folder.path / "b.png");
    CHECK(read_bytes(folder.path / "a.png") == read_bytes(folder.path / "b.png"));
    CHECK(read_bytes(folder.path / "a.png").size() == render::write_png_file(image, folder.path / "c.png"));
}

TEST_CASE("an image whose buffer does not fit its size is refused") {
    const TemporaryFolder folder;
    Image image = test_image(8, 8);
    image.rgba.pop_back();
    CHECK_THROWS_WITH_AS(write_png(image, folder.path / "x.png"), "not an image: 8x8 with 255 bytes",
                         std::invalid_argument);
    CHECK_THROWS_AS(write_png(Image{}, folder.path / "x.png"), std::invalid_argument);
    CHECK(file_count(folder.path) == 0);
}

TEST_CASE("a folder that does not exist is named in the error") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "missing" / "x.png";
    const std::string message = message_of_failed_write(test_image(8, 8), file);
    CHECK(message.find(file.string()) != std::string::npos);
    CHECK(message.find("No such file or directory") != std::string::npos);
}

TEST_CASE("a write over the size limit is an error, keeps the old file and leaves no temporary one") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "x.png";
    write_png(test_image(8, 8), file);
    const std::vector<std::uint8_t> before = read_bytes(file);

    rlimit old_limit{};
    REQUIRE(getrlimit(RLIMIT_FSIZE, &old_limit) == 0);
    rlimit limit = old_limit;
    limit.rlim_cur = 1000;  // less than the image below needs
    auto* const old_handler = std::signal(SIGXFSZ, SIG_IGN);
    REQUIRE(setrlimit(RLIMIT_FSIZE, &limit) == 0);
    const std::string message = message_of_failed_write(test_image(300, 300), file);
    REQUIRE(setrlimit(RLIMIT_FSIZE, &old_limit) == 0);
    std::signal(SIGXFSZ, old_handler);

    CHECK(message.find(file.string()) != std::string::npos);
    CHECK(message.find("File too large") != std::string::npos);
    CHECK(read_bytes(file) == before);
    CHECK(file_count(folder.path) == 1);
}

TEST_CASE("a full disk is an error with that reason") {
    const TemporaryFolder folder;
    const test::SmallDisk disk(folder.path / "disk", 16);
    const std::string message = message_of_failed_write(test_image(300, 300), folder.path / "disk/x.png");
    CHECK(message.find("No space left on device") != std::string::npos);
    CHECK(file_count(folder.path / "disk") == 0);
}

TEST_CASE("a mask is a PNG file with 16 bits that decodes to its labels") {
    const TemporaryFolder folder;
    Mask mask{37, 21, {}};
    for (unsigned i = 0; i < 37 * 21; ++i) mask.labels.push_back(static_cast<BodyLabel>(i * i * 2654435761u >> 7));
    mask.labels[5] = 65535;
    mask.labels[6] = 0;
    const std::filesystem::path file = folder.path / "mask.png";
    const std::uint64_t size = write_mask_png(mask, file);
    CHECK(size == std::filesystem::file_size(file));
    CHECK(stbi_is_16_bit(file.c_str()) == 1);
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_us, decltype(&stbi_image_free)> decoded(
        stbi_load_16(file.c_str(), &width, &height, &channels, 0), stbi_image_free);
    REQUIRE(decoded);
    CHECK(width == 37);
    CHECK(height == 21);
    CHECK(channels == 1);
    CHECK(std::vector<BodyLabel>(decoded.get(), decoded.get() + mask.labels.size()) == mask.labels);
    CHECK(mask.labels.size() == std::size_t{37} * 21);
}
