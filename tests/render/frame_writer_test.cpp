// The encoder threads: every frame is written, buffers are reused, the first error stops the rest.
#include <doctest/doctest.h>

#include <filesystem>
#include <set>
#include <string>

#include "render/output/png.hpp"
#include "support/temporary_folder.hpp"
#include "tumble/file.hpp"
#include "tumble/render.hpp"

using namespace tumble;

namespace {

void fill(Image& image, int size, int value) {
    image.width = image.height = size;
    image.rgba.assign(std::size_t{4} * static_cast<std::size_t>(size) * static_cast<std::size_t>(size),
                      static_cast<std::uint8_t>(value));
}

}  // namespace

TEST_CASE("every submitted frame is written, for any number of threads") {
    for (const int threads : {1, 3}) {
        const TemporaryFolder folder;
        FrameWriter writer(threads);
        for (int i = 0; i < 40; ++i) {
            Image image = writer.take_image();
            fill(image, 32, i);
            writer.submit(std::move(image), folder.path / (std::to_string(i) + ".png"));
        }
        const FrameWriter::Written written = writer.finish();
        CHECK(written.files == 40);
        std::uint64_t bytes = 0;
        for (int i = 0; i < 40; ++i) {
            const std::filesystem::path file = folder.path / (std::to_string(i) + ".png");
            REQUIRE(std::filesystem::exists(file));
            bytes += std::filesystem::file_size(file);
            Image image;
            fill(image, 32, i);
            CHECK(std::filesystem::file_size(file) == to_png(image).size());
        }
        CHECK(written.bytes == bytes);
        CHECK(written.encode_seconds > 0.0);
    }
}

TEST_CASE("image buffers are reused") {
    const TemporaryFolder folder;
    FrameWriter writer(2);
    std::set<const std::uint8_t*> buffers;
    for (int i = 0; i < 60; ++i) {
        Image image = writer.take_image();
        fill(image, 64, i);
        buffers.insert(image.rgba.data());
        writer.submit(std::move(image), folder.path / "x.png");
    }
    writer.finish();
    // Two are being encoded, three queued, one is drawn into; up to two more may be free.
    CHECK(buffers.size() <= 8);
}

TEST_CASE("submit and finish report the first failure, every time") {
    const TemporaryFolder folder;
    FrameWriter writer(1);
    Image image;
    fill(image, 16, 0);
    writer.submit(image, folder.path / "good.png");
    writer.submit(image, folder.path / "missing" / "bad.png");
    const auto submit_many = [&] {
        for (int i = 0; i < 100; ++i) writer.submit(image, folder.path / "late.png");
        writer.finish();
    };
    CHECK_THROWS_AS(submit_many(), FileError);
    CHECK_THROWS_AS(writer.finish(), FileError);
    CHECK_THROWS_AS(writer.submit(image, folder.path / "later.png"), FileError);
    CHECK(std::filesystem::exists(folder.path / "good.png"));
    CHECK_FALSE(std::filesystem::exists(folder.path / "later.png"));
}

TEST_CASE("a writer without threads is refused") {
    CHECK_THROWS_AS(FrameWriter(0), std::invalid_argument);
    CHECK_THROWS_AS(FrameWriter(-3), std::invalid_argument);
}

TEST_CASE("the destructor writes the frames that were submitted") {
    const TemporaryFolder folder;
    {
        FrameWriter writer(2);
        Image image;
        fill(image, 16, 9);
        for (int i = 0; i < 5; ++i) writer.submit(image, folder.path / (std::to_string(i) + ".png"));
    }
    for (int i = 0; i < 5; ++i) CHECK(std::filesystem::exists(folder.path / (std::to_string(i) + ".png")));
}
