// Scenes of every format up to the present one are read: tests/scene/formats/N holds scenes as they were written when
// the format was N. scenes/FORMATS.md is the policy.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tumble/file.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;

namespace {

namespace fs = std::filesystem;

const fs::path kFormats = fs::path(TUMBLE_SOURCE_DIR) / "tests" / "scene" / "formats";

int format_of(const std::string& scene) { return nlohmann::json::parse(scene, nullptr, true, true).at("format"); }

int present_format() { return nlohmann::json::parse(scene_schema()).at("properties").at("format").at("const"); }

std::vector<fs::path> scenes_of_format(int format) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(kFormats / std::to_string(format)))
        files.push_back(entry.path());
    return files;
}

}  // namespace

TEST_CASE("scenes of every format up to the present one are read, run, and are written in the present one") {
    for (int format = 1; format <= present_format(); ++format) {
        CAPTURE(format);
        REQUIRE(fs::is_directory(kFormats / std::to_string(format)));
        const std::vector<fs::path> files = scenes_of_format(format);
        CHECK(!files.empty());
        for (const fs::path& file : files) {
            CAPTURE(file);
            CHECK(format_of(read_file(file, 1u << 20)) == format);
            const Scene scene = load_scene(file);
            CHECK(scene.bodies.size() > 1);
            CHECK(format_of(to_json(scene)) == present_format());
            SceneRun run(scene);
            for (int i = 0; i < 10; ++i) run.step();
            run.world().audit();
        }
    }
}

TEST_CASE("there are no scenes of a format that does not exist yet") {
    CHECK(!fs::exists(kFormats / std::to_string(present_format() + 1)));
}

TEST_CASE("a scene of a format that does not exist yet is refused by its number") {
    const int next = present_format() + 1;
    try {
        (void)parse_scene(R"({"format": )" + std::to_string(next) + "}", "newer.json");
        FAIL("it was read");
    } catch (const SceneError& error) {
        REQUIRE(error.diagnostics.size() == 1);
        CHECK(error.diagnostics[0].pointer == "/format");
        CHECK(error.diagnostics[0].message.find("got " + std::to_string(next)) != std::string::npos);
    }
}
