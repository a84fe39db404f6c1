// libFuzzer target over the R.U.B.E. importer: any text is an export that becomes a scene which builds, or an error.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tumble/scene_file.hpp"
#include "tumble/scene_import.hpp"
#include "tumble/scene_world.hpp"

using namespace tumble;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        build_world(parse_rube({reinterpret_cast<const char*>(data), size}, "fuzzed.json").scene);
    } catch (const SceneError&) {
    }
    return 0;
}
