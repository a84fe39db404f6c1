#include "tools/run/fallen.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tools/output/json_writer.hpp"
#include "tools/run/step_files.hpp"

namespace tumble::tools {

namespace {

// Along gravity (m, unit direction): how deep the deepest and the highest point of what does not move lie.
struct Range {
    double highest = HUGE_VAL, deepest = -HUGE_VAL;
};

Range range_of_grounds(const World& world, DVec2 down) {
    Range range;
    for (const BodyId body : world.bodies()) {
        if (world.type(body) == BodyType::dynamic_body) continue;
        for (const ShapeId shape : world.shapes(body)) {
            if (world.is_sensor(shape)) continue;
            const Aabb box = bounds(world.shape(shape), world.state(body).pose);
            for (const Vec2 corner :
                 {box.lower, box.upper, Vec2{box.lower.x, box.upper.y}, Vec2{box.upper.x, box.lower.y}}) {
                range.highest = std::min(range.highest, dot(DVec2(corner), down));
                range.deepest = std::max(range.deepest, dot(DVec2(corner), down));
            }
        }
    }
    return range;
}

}  // namespace

std::string fallen_text(const SceneWorld& built) {
    const World& world = built.world;
    const DVec2 gravity(world.def().gravity);
    if (!(length(gravity) > 0.0)) return {};
    const DVec2 down = (1.0 / length(gravity)) * gravity;
    const Range grounds = range_of_grounds(world, down);
    // As far again as the grounds are high, and ten bodies: who is there has nothing to come back to.
    const double lost = grounds.deepest + std::max(grounds.deepest - grounds.highest, 10.0 * double{world.def().scale});
    std::size_t count = 0, first = 0;
    for (std::size_t i = 0; i < built.bodies.size(); ++i) {
        const BodyId body = built.bodies[i].id;
        if (!world.is_valid(body) || world.type(body) != BodyType::dynamic_body || !std::isfinite(lost)) continue;
        if (dot(world.state(body).pose.position, down) > lost && count++ == 0) first = i;
    }
    if (count == 0) return {};
    const std::string name = "'" + output_name(built.bodies[first], first) + "'";
    std::string text = name + (count > 1 ? " and " + std::to_string(count - 1) + " more have" : " has") +
                       " fallen below all that could hold " + (count > 1 ? "them: " : "it: ") + name + " is at y = ";
    append_number(text, static_cast<float>(world.state(built.bodies[first].id).pose.position.y));
    return text + " m at the end";
}

}  // namespace tumble::tools
