// libFuzzer target over the scene reader: any text is a scene that writes itself, reads itself back, builds and steps,
// or an error. Each include reads the same part, which has an element of each kind that the pose of a part moves.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"
#include "tumble/scene_world.hpp"

using namespace tumble;

namespace {

constexpr const char* kPart = R"({
    "format": 1,
    "materials": {"m": {"friction": 0.1}},
    "bodies": [{"name": "a", "position": [1, 2], "angle": 3, "velocity": [1, 0], "shapes": [{"circle": {"radius": 1}, "material": "m"}]},
               {"name": "b", "position": [4, 2], "repeat": {"grid": {"columns": 2}}}],
    "joints": [{"type": "prismatic", "name": "j", "bodies": ["a", "b[0]"], "anchor": [1, 2], "axis": [1, 0]}],
    "timeline": [{"at": 0.01, "body": "a", "impulse": [1, 0]}, {"every": 0.1, "spawn": {"name": "c"}}],
    "expect": [{"body": "a", "inside": [[0, 0], [2, 3]]}]})";

LoadOptions with_part() {
    LoadOptions options;
    options.read_included = [](const std::filesystem::path&) { return kPart; };
    return options;
}

// What was written must be read as the same scene.
void require_same(const Scene& scene) {
    const std::string text = to_json(scene);
    try {
        if (to_json(parse_scene(text, "written.json")) != text) std::abort();
    } catch (const SceneError&) {
        std::abort();
    }
}

// `check --update` replaces a hash in the text of a file, which must stay a scene.
void require_replaced(std::string_view text, const Scene& scene) {
    for (std::size_t i = 0; i < scene.expect.size(); ++i) {
        if (scene.expect[i].state_hash.empty()) continue;
        const std::string pointer = "/expect/" + std::to_string(i) + "/state_hash", hash = "0123456789abcdef";
        const Scene replaced =
            parse_scene(replace_text(std::string(text), pointer, hash), "replaced.json", with_part());
        if (replaced.expect.at(i).state_hash != hash) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t kManyBodies = 200;  // a repeater of a few bytes may make a million
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const Scene scene = parse_scene(text, "fuzzed.json", with_part());
        if (size > 4096 || count_bodies(scene) > kManyBodies) return 0;
        require_same(scene);
        require_replaced(text, scene);
        SceneRun run(scene);
        run.step();
    } catch (const SceneError&) {
    } catch (const SimulationDiverged&) {
    }
    return 0;
}
