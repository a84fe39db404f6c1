// libFuzzer target over the SVG importer: any text is a drawing that becomes a scene which builds, or an error.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tumble/scene_file.hpp"
#include "tumble/scene_import.hpp"
#include "tumble/scene_world.hpp"

using namespace tumble;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        build_world(parse_svg({reinterpret_cast<const char*>(data), size}, "fuzzed.svg").scene);
    } catch (const SceneError&) {
    }
    return 0;
}
