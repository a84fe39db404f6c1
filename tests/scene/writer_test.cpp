// Writing: canonical, short, exact, and never half a file.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "scene/example.hpp"
#include "scene/json/json_text.hpp"
#include "scene/reread.hpp"
#include "scene/shipped.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"

using namespace tumble;
using test::reread;

namespace {

std::filesystem::path temporary_folder() {
    std::filesystem::path folder = std::filesystem::path(TUMBLE_BINARY_DIR) / "scene_test";
    std::filesystem::create_directories(folder);
    return folder;
}

}  // namespace

TEST_CASE("the canonical text leaves defaults out and keeps short values on one line") {
    Scene scene;
    scene.name = "two";
    scene.world.seed = 18446744073709551615u;
    SceneBody ground;
    ground.type = BodyType::static_body;
    ground.shapes.push_back({BoxGeometry{{40, 1}, 0, {}, 0}, "", ""});
    scene.bodies.push_back(ground);
    CHECK(to_json(scene) ==
          "{\n"
          "  \"format\": 1,\n"
          "  \"name\": \"two\",\n"
          "  \"world\": {\"seed\": 18446744073709551615},\n"
          "  \"bodies\": [{\"type\": \"static\", \"shapes\": [{\"box\": {\"size\": [40, 1]}}]}]\n"
          "}\n");
}

TEST_CASE("writing and reading again changes nothing, for the example and every shipped scene") {
    CHECK(to_json(parse_scene(test::kExample, "")) == to_json(reread(parse_scene(test::kExample, ""))));
    for (const std::filesystem::path& file : test::shipped_scenes()) {
        const Scene scene = load_scene(file);
        CHECK(to_json(scene) == to_json(reread(scene)));
        CHECK(scene_hash(scene) == scene_hash(reread(scene)));
    }
}

TEST_CASE("doubles from 1e-9 to 1e9 survive writing and reading bit for bit") {
    std::mt19937_64 random(1);
    int fractions = 0;
    constexpr int kSamples = 2000;
    for (int sample = 0; sample < kSamples; ++sample) {
        const double exponent = -9.0 + 18.0 * static_cast<double>(random() >> 11) * 0x1p-53;
        Scene scene;
        scene.bodies.emplace_back();
        scene.bodies.at(0).position.x = std::pow(10.0, exponent) * ((random() & 1) ? 1.0 : -1.0);
        if (scene.bodies.at(0).position.x != std::floor(scene.bodies.at(0).position.x)) ++fractions;
        CHECK(reread(scene).bodies.at(0).position.x == scene.bodies.at(0).position.x);
    }
    CHECK(fractions > kSamples / 2);
}

TEST_CASE("numbers are written in their shortest form") {
    CHECK(scene::number_text(0.1) == "0.1");
    CHECK(scene::number_text(-0.0) == "0");
    CHECK(scene::number_text(100000) == "100000");
    CHECK(scene::number_text(1.0 / 3.0) == "0.3333333333333333");
    CHECK(scene::number_text(1e300) == "1e+300");
    CHECK(scene::number_text(5e-324) == "5e-324");
    CHECK_THROWS_AS(scene::number_text(INFINITY), std::invalid_argument);
}

TEST_CASE("custom JSON keeps its order; text that is not JSON is refused") {
    const Scene scene = parse_scene(R"({"format": 1, "custom": {"z": [1, 2.50, "é"], "a": null}})", "");
    CHECK(scene.custom == R"({"z": [1, 2.5, "é"], "a": null})");
    CHECK(reread(scene).custom == scene.custom);
    Scene broken;
    broken.custom = "{";
    CHECK_THROWS_AS(to_json(broken), std::invalid_argument);
}

TEST_CASE("the scene hash covers the simulated part only") {
    const Scene scene = parse_scene(test::kExample, "");
    Scene same = scene;
    same.schema = same.name = same.description = "x";
    same.custom = same.bodies.at(0).custom = same.bodies.at(0).shapes.at(0).custom = same.joints.at(0).custom =
        "{\"a\": 1}";
    same.materials.at(0).color = "#000";
    same.camera = {};
    same.expect.clear();
    CHECK(scene_hash(same) == scene_hash(scene));
    Scene other = scene;
    other.bodies.at(0).position.x = 1e-300;
    CHECK(scene_hash(other) != scene_hash(scene));
    other = scene;
    other.materials.at(0).friction = 0.03;
    CHECK(scene_hash(other) != scene_hash(scene));
    other = scene;
    other.world.seed = 2;
    CHECK(scene_hash(other) != scene_hash(scene));
}

TEST_CASE("the scene hash is that of the canonical text") {
    // xxHash64 with seed 0 of the 13 bytes {"format": 1}.
    CHECK(scene_hash(Scene{}) == 0x0d692d35284d81f0u);
}

TEST_CASE("saving replaces the whole file and leaves nothing else behind") {
    const std::filesystem::path folder = temporary_folder() / "save";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const std::filesystem::path file = folder / "scene.json";
    const Scene scene = parse_scene(test::kExample, "");
    save_scene(Scene{}, file);
    save_scene(scene, file);
    CHECK(to_json(load_scene(file)) == to_json(scene));
    CHECK(std::distance(std::filesystem::directory_iterator(folder), {}) == 1);
}

TEST_CASE("a failed save is a FileError and keeps the old file") {
    const std::filesystem::path folder = temporary_folder();
    CHECK_THROWS_AS(save_scene(Scene{}, folder / "no" / "folder" / "scene.json"), FileError);
    const std::filesystem::path occupied = folder / "occupied";
    std::filesystem::create_directories(occupied / "inside");
    CHECK_THROWS_AS(save_scene(Scene{}, occupied), FileError);  // a folder cannot be replaced by a file
    CHECK(std::filesystem::is_directory(occupied / "inside"));
    CHECK(!std::filesystem::exists(folder / "no"));
}
