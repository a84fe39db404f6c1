// Images of bodies: which pixels they have, in which order, and what becomes of files that are missing or wrong.
#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "render/pixels.hpp"
#include "tumble/file.hpp"
#include "tumble/render.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;
using render::pixel;
namespace fs = std::filesystem;

namespace {

// A folder with a picture of 2 by 1 pixels, red and green, and one of a transparent pixel; removed at the end.
struct Pictures {
    fs::path folder = fs::temp_directory_path() / ("tumble_images_" + std::to_string(::getpid()));
    Pictures() {
        fs::create_directories(folder / "in");
        write_png({2, 1, {255, 0, 0, 255, 0, 255, 0, 255}}, folder / "in/red_green.png");
        write_png({1, 1, {0, 0, 255, 255}}, folder / "in/blue.png");
        write_png({1, 1, {255, 255, 255, 0}}, folder / "in/clear.png");
        write_png({1, 1, {0, 0, 0, 255}}, folder / "outside.png");
    }
    ~Pictures() { fs::remove_all(folder); }

    // The scene of a static body with these images, and more bodies, in the folder `in`.
    fs::path scene(const std::string& images, const std::string& bodies = "", const std::string& place = "") const {
        fs::path file = folder / "in/scene.json";
        std::ofstream(file) << R"({"format": 1, "camera": {"center": [0, 0], "height": 8},
            "materials": {"white": {"color": "#fff"}}, "bodies": [)" +
                                   bodies + R"({"type": "static", )" + place + R"("images": [)" + images + "]}]}";
        return file;
    }
};

// 80 by 80 pixels, 10 for a metre, with the origin in the middle.
Image frame_of(const fs::path& file, Renderer& renderer) {
    const Scene scene = load_scene(file);
    SceneRun run(scene);
    Overlay plain;
    plain.title = plain.time = plain.scale_bar = plain.grid = false;
    Image image;
    renderer.draw(scene, run.built(), make_camera(scene, run.built(), 1.0), 0.0, image, plain);
    return image;
}

Image frame_of(const fs::path& file) {
    Renderer renderer(80, 80);
    return frame_of(file, renderer);
}

constexpr Color kRed{255, 0, 0}, kGreen{0, 255, 0}, kBlue{0, 0, 255};

bool near(Color a, Color b) { return std::abs(a.r - b.r) <= 2 && std::abs(a.g - b.g) <= 2 && std::abs(a.b - b.b) <= 2; }

}  // namespace

TEST_CASE("an image has its size, its place and its rotation in the body") {
    const Pictures pictures;
    // 2 m wide by its proportions: red from -1 to 0 m, green from 0 to 1 m, 0.5 m up and down, 1 m above the middle.
    const std::string file = R"({"file": "red_green.png", "height": 1, "center": [0, 1])";
    const Image image = frame_of(pictures.scene(file + "}"));
    CHECK(near(pixel(image, 32, 30), kRed));
    CHECK(near(pixel(image, 47, 30), kGreen));
    CHECK(near(pixel(image, 32, 26), kRed));
    CHECK(pixel(image, 28, 30) == pixel(image, 0, 0));
    CHECK(pixel(image, 32, 23) == pixel(image, 0, 0));
    CHECK(pixel(image, 32, 37) == pixel(image, 0, 0));
    const Image flipped = frame_of(pictures.scene(file + R"(, "flip": true})"));
    CHECK(near(pixel(flipped, 32, 30), kGreen));
    CHECK(near(pixel(flipped, 47, 30), kRed));
    // Turned by 90 degrees in a body that is turned by 90 degrees, and 1 m to its left: red is on the right.
    const Image turned = frame_of(pictures.scene(file + R"(, "angle": 90})", "", R"("angle": 90, )"));
    CHECK(near(pixel(turned, 37, 40), kRed));
    CHECK(near(pixel(turned, 22, 40), kGreen));
    const Image wide = frame_of(pictures.scene(file + R"(, "width": 6})"));
    CHECK(near(pixel(wide, 12, 30), kRed));
    CHECK(near(pixel(wide, 67, 30), kGreen));
}

TEST_CASE("images cover bodies and each other in their order, as much as they are opaque") {
    const Pictures pictures;
    const std::string box = R"({"type": "static", "shapes": [{"box": {"size": [2, 2]}, "material": "white"}]}, )";
    const auto middle = [&](const std::string& images) { return pixel(frame_of(pictures.scene(images, box)), 40, 40); };
    const std::string blue = R"({"file": "blue.png", "height": 4, "order": )",
                      red = R"({"file": "red_green.png", "height": 4, "center": [3.9, 0], "order": )";
    CHECK(near(middle(blue + "1}, " + red + "2}"), kRed));
    CHECK(near(middle(blue + "2}, " + red + "1}"), kBlue));
    CHECK(near(middle(blue + "-1}"), {255, 255, 255}));
    CHECK(near(middle(blue + R"(0, "opacity": 0.5})"), {128, 128, 255}));
    CHECK(near(middle(R"({"file": "clear.png", "height": 4})"), {255, 255, 255}));
}

TEST_CASE("a missing file leaves the outline of its image; one that is damaged, too large or outside is an error") {
    const Pictures pictures;
    const Image image = frame_of(pictures.scene(R"({"file": "missing.png", "height": 2, "width": 4})"));
    const Color empty = pixel(image, 0, 0);
    CHECK(pixel(image, 40, 40) == empty);
    CHECK(pixel(image, 40, 30) != empty);  // the upper side
    CHECK(pixel(image, 20, 40) != empty);  // the left side
    CHECK(pixel(image, 18, 40) == empty);

    std::ofstream(pictures.folder / "in/damaged.png") << "no picture";
    CHECK_THROWS_AS(frame_of(pictures.scene(R"({"file": "damaged.png", "height": 2})")), PictureError);
    fs::create_directory(pictures.folder / "in/folder.png");
    fs::create_symlink("loop.png", pictures.folder / "in/loop.png");
    mkfifo((pictures.folder / "in/pipe.png").c_str(), 0600);  // opening it would wait forever
    for (const std::string file : {"folder", "loop", "pipe"})
        CHECK_THROWS_AS(frame_of(pictures.scene(R"({"file": ")" + file + R"(.png", "height": 2})")), FileError);
    write_png({kLargestFrame + 1, 1, std::vector<std::uint8_t>(std::size_t{4} * (kLargestFrame + 1))},
              pictures.folder / "in/wide.png");
    CHECK_THROWS_AS(frame_of(pictures.scene(R"({"file": "wide.png", "height": 2})")), PictureError);
    CHECK_THROWS_WITH_AS(read_picture("/dev/zero"), "/dev/zero: is a pipe or a device, no file", PictureError);
    const fs::path outside = pictures.scene(R"({"file": "../outside.png", "height": 2})");
    CHECK_THROWS_WITH_AS(load_scene(outside), doctest::Contains("/bodies/0/images/0/file: leads out of the folder"),
                         SceneError);
    LoadOptions allowed;
    allowed.allow_outside = true;
    CHECK(load_scene(outside, allowed).bodies.at(0).images.at(0).path == pictures.folder / "outside.png");
}

TEST_CASE("a renderer refuses a damaged image each time, and draws it once it is mended") {
    const Pictures pictures;
    std::ofstream(pictures.folder / "in/damaged.png") << "no picture";
    const fs::path file = pictures.scene(R"({"file": "damaged.png", "height": 2})");
    Renderer renderer(80, 80);
    CHECK_THROWS_AS(frame_of(file, renderer), PictureError);
    CHECK_THROWS_AS(frame_of(file, renderer), PictureError);
    write_png({1, 1, {0, 0, 255, 255}}, pictures.folder / "in/damaged.png");
    CHECK(near(pixel(frame_of(file, renderer), 40, 40), kBlue));
}

TEST_CASE("a renderer draws any number of scenes whose images have at most 64 million pixels each") {
    const Pictures pictures;
    // 8192 by 4096 pixels are 33.6 million: two such images are too many for a scene.
    Image large{kLargestFrame, kLargestFrame / 2,
                std::vector<std::uint8_t>(std::size_t{2} * kLargestFrame * kLargestFrame)};
    for (std::size_t i = 0; i < large.rgba.size(); i += 4) large.rgba[i] = large.rgba[i + 3] = 255;
    for (const char* const name : {"in/first.png", "in/second.png"}) write_png(large, pictures.folder / name);
    const std::string first = R"({"file": "first.png", "height": 4})",
                      second = R"({"file": "second.png", "height": 4})";
    Renderer renderer(80, 80);
    for (const std::string& images : {first, second + ", " + second})
        CHECK(near(pixel(frame_of(pictures.scene(images), renderer), 40, 40), kRed));
    CHECK_THROWS_WITH_AS(frame_of(pictures.scene(first + ", " + second), renderer),
                         doctest::Contains("more than 64 million pixels"), PictureError);
}

TEST_CASE("images have no effect on the simulation, and a part keeps those of its own folder") {
    const Pictures pictures;
    const std::string ball =
        R"({"name": "ball", "position": [0, 2], "shapes": [{"circle": {"radius": 1}}], "images": [)";
    const auto hash_after = [&](const std::string& images) {
        const Scene scene = load_scene(pictures.scene("", ball + images + "]}, "));
        SceneRun run(scene);
        for (int i = 0; i < 60; ++i) run.step();
        return std::pair{run.world().state_hash(), scene_hash(scene)};
    };
    CHECK(hash_after("") == hash_after(R"({"file": "blue.png", "height": 2})"));

    const fs::path part = pictures.scene(R"({"file": "blue.png", "height": 2})"),
                   whole = pictures.folder / "whole.json";
    std::ofstream(whole)
        << R"({"format": 1, "include": [{"file": "in/scene.json", "position": [1, 0]}], "camera": {"center": [0, 0], "height": 8}})";
    const SceneImage image = load_scene(whole).bodies.at(0).images.at(0);
    CHECK(image.file == "in/blue.png");
    CHECK(image.path == pictures.folder / "in/blue.png");
    CHECK(near(pixel(frame_of(whole), 50, 40), kBlue));
}
