// libFuzzer target over the scene reader: any text is a scene that builds, steps and writes itself, or an error.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tumble/scene.hpp"

using namespace tumble;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t kManyBodies = 200;  // a repeater of a few bytes may make a million
    try {
        const Scene scene = parse_scene({reinterpret_cast<const char*>(data), size}, "fuzzed.json");
        parse_scene(to_json(scene), "written.json");
        if (size > 4096) return 0;
        SceneWorld built = build_world(scene);
        if (built.bodies.size() <= kManyBodies) built.world.step();
    } catch (const SceneError&) {
    } catch (const SimulationDiverged&) {
    }
    return 0;
}
