// libFuzzer target over expressions: any text has a value and a finding, or an error inside the text; a prefix before
// its names keeps it an expression.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "scene/expressions/program.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;

namespace {

constexpr const char* kScene = R"({"format": 1, "bodies": [
    {"name": "a", "position": [1, 2], "shapes": [{"circle": {"radius": 1}}]},
    {"name": "b", "position": [2, 3], "shapes": [{"box": {"size": [1, 1]}}]},
    {"name": "c", "position": [9, 2], "repeat": {"grid": {"columns": 3}}, "shapes": [{"circle": {"radius": 0.4}}]}],
  "joints": [{"type": "revolute", "name": "j", "bodies": ["a", "b"], "anchor": [1, 2]}],
  "timeline": [{"at": 1, "spawn": {"name": "d"}}]})";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Scene scene = parse_scene(kScene, "scene.json");
    static const SceneWorld built = build_world(scene);
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const Expression expression(text, scene);
        expression.value(built);
        if (expression.holds(built) != (expression.shortfall(built) <= 0.0)) std::abort();
        expression.finding(built);
    } catch (const ExpressionError& error) {
        if (error.offset > size) std::abort();
        return 0;
    }
    const std::string prefixed = scene::with_prefix(text, "p/");
    if (prefixed.size() <= 2000 && scene::with_prefix(prefixed, "").size() != prefixed.size()) std::abort();
    return 0;
}
