#include "tools/health/lost_bodies.hpp"

#include <cstddef>
#include <vector>

#include "tools/output/json_writer.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

std::string lost_bodies_text(const SceneWorld& built) {
    const std::vector<std::size_t> lost = find_lost_bodies(built);
    if (lost.empty()) return {};
    const SceneInstance& first = built.bodies[lost.front()];
    const std::string name = "'" + output_name(first, lost.front()) + "'";
    std::string text = name + (lost.size() > 1 ? " and " + std::to_string(lost.size() - 1) + " more have" : " has") +
                       " fallen below all static and kinematic shapes: " + name + " is at y = ";
    append_number(text, static_cast<float>(built.world.state(first.id).pose.position.y));
    return text + " m at the end";
}

}  // namespace tumble::tools
