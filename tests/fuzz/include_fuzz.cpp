// libFuzzer target over included files: any two texts, a scene and the part that each of its includes reads, are a
// scene that writes itself and builds, or an error. A part may include itself and other files, which have the same
// text. The first byte tells where the first text ends.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "scratch_file.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_world.hpp"

using namespace tumble;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t kManyBodies = 200;  // a repeater of a few bytes may make a million
    if (size == 0) return 0;
    const std::string_view text = fuzz::text_of(data + 1, size - 1);
    const std::size_t end = text.size() * data[0] / 256;
    LoadOptions options;
    options.read_included = [&](const std::filesystem::path&) { return std::string(text.substr(end)); };
    try {
        const Scene scene = parse_scene(text.substr(0, end), "fuzzed.json", options);
        if (size > 4096 || count_bodies(scene) > kManyBodies) return 0;
        const std::string flat = to_json(scene);
        if (to_json(parse_scene(flat, "flat.json")) != flat) std::abort();
        build_world(scene);
    } catch (const SceneError&) {
    }
    return 0;
}
