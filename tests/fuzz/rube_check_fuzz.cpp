// libFuzzer target over `import --check`: an export that the importer accepts is compared with Box2D, whose assertions
// would abort.
#include <cstddef>
#include <cstdint>

#include "reference/box2d/b2_rube.hpp"
#include "scratch_file.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_import.hpp"

using namespace tumble;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::ScratchFile file("fuzzed.json");
    try {
        const Scene scene = parse_rube(fuzz::text_of(data, size), "fuzzed.json").scene;
        if (scene.bodies.size() < 200) reference::compare_with_box2d(file.write(fuzz::text_of(data, size)), scene);
    } catch (const SceneError&) {
    }
    return 0;
}
