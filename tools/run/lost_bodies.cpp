#include "tools/run/lost_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tools/output/json_writer.hpp"
#include "tools/tables/step_files.hpp"

namespace tumble::tools {

namespace {

// Extent of all static and kinematic shapes along the direction of gravity (m, positive downwards).
struct Extent {
    double highest = HUGE_VAL, deepest = -HUGE_VAL;
};

Extent extent_of_grounds(const World& world, DVec2 down) {
    Extent extent;
    for (const BodyId body : world.bodies()) {
        if (world.type(body) == BodyType::dynamic_body) continue;
        for (const ShapeId shape : world.shapes(body)) {
            if (world.is_sensor(shape)) continue;
            const Aabb box = bounds(world.shape(shape), world.state(body).pose);
            for (const Vec2 corner :
                 {box.lower, box.upper, Vec2{box.lower.x, box.upper.y}, Vec2{box.upper.x, box.lower.y}}) {
                extent.highest = std::min(extent.highest, dot(DVec2(corner), down));
                extent.deepest = std::max(extent.deepest, dot(DVec2(corner), down));
            }
        }
    }
    return extent;
}

}  // namespace

std::string lost_bodies_text(const SceneWorld& built) {
    const World& world = built.world;
    const DVec2 gravity(world.def().gravity);
    if (!(length(gravity) > 0.0)) return {};
    const DVec2 down = (1.0 / length(gravity)) * gravity;
    const Extent grounds = extent_of_grounds(world, down);
    // Below the grounds by their own height, or by ten typical bodies if that is more.
    const double limit =
        grounds.deepest + std::max(grounds.deepest - grounds.highest, 10.0 * double{world.def().scale});
    std::size_t count = 0, first = 0;
    for (std::size_t i = 0; i < built.bodies.size(); ++i) {
        const BodyId body = built.bodies[i].id;
        if (!world.is_valid(body) || world.type(body) != BodyType::dynamic_body || !std::isfinite(limit)) continue;
        if (dot(world.state(body).pose.position, down) > limit && count++ == 0) first = i;
    }
    if (count == 0) return {};
    const std::string name = "'" + output_name(built.bodies[first], first) + "'";
    std::string text = name + (count > 1 ? " and " + std::to_string(count - 1) + " more have" : " has") +
                       " fallen below all static and kinematic shapes: " + name + " is at y = ";
    append_number(text, static_cast<float>(world.state(built.bodies[first].id).pose.position.y));
    return text + " m at the end";
}

}  // namespace tumble::tools
