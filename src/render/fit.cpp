#include "render/fit.hpp"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

namespace tumble::render {
namespace {

// Lengths here are shares of the larger side of what moves.
constexpr double kNear = 0.5;           // things that end this near beside or above it are shown to their ends
constexpr double kCut = 0.1;            // things that go on are shown this far
constexpr double kGroundShown = 0.06;   // and a thick ground this far below its top
constexpr double kSunk = 0.02;          // a ground that reaches this far into what lies on it is still below it
constexpr double kFarthestFall = 40.0;  // how far below a ground is looked for
constexpr double kRoomForAll = 1.75;    // how much higher a frame may become to show all that never moves

Box box_of(const Aabb& bounds) {
    if (!is_finite(bounds.lower) || !is_finite(bounds.upper)) return {};
    return {DVec2(bounds.lower), DVec2(bounds.upper)};
}

double larger_side(const Box& box) { return std::max(box.size().x, box.size().y); }

// All places that a body can turn to about a point of its own.
Box swept_box(const World& world, BodyId body, Vec2 pivot) {
    double radius = 0.0;
    for (const ShapeId shape : world.shapes(body))
        radius = std::max(radius, double{farthest_distance(world.shape(shape), pivot)});
    const DVec2 center = transform_point(world.state(body).pose, pivot);
    if (!is_finite(center) || !std::isfinite(radius)) return {};
    return {center - DVec2{radius, radius}, center + DVec2{radius, radius}};
}

Box moving_box(const World& world) {
    Box box;
    for (const BodyId body : world.bodies()) {
        if (world.type(body) == BodyType::static_body) continue;
        const BodyState state = world.state(body);
        for (const ShapeId shape : world.shapes(body)) box.add(box_of(bounds(world.shape(shape), state.pose)));
        if (state.angular_velocity != 0.0f) box.add(swept_box(world, body, world.mass(body).center));
    }
    // Rotors, swings and planks turn about their hinges.
    for (const JointId id : world.joints()) {
        const auto* hinge = std::get_if<RevoluteJointDef>(&world.joint(id));
        if (!hinge) continue;
        if (world.type(hinge->body_a) != BodyType::static_body)
            box.add(swept_box(world, hinge->body_a, hinge->anchor_a));
        if (world.type(hinge->body_b) != BodyType::static_body)
            box.add(swept_box(world, hinge->body_b, hinge->anchor_b));
    }
    return box;
}

std::vector<Box> static_boxes(const World& world) {
    std::vector<Box> boxes;
    for (const BodyId body : world.bodies()) {
        if (world.type(body) != BodyType::static_body) continue;
        const Pose pose = world.state(body).pose;
        for (const ShapeId shape : world.shapes(body))
            if (const Box box = box_of(bounds(world.shape(shape), pose)); !box.is_empty()) boxes.push_back(box);
    }
    return boxes;
}

// What moves, grown downwards by what it may fall on and sidewards by what is near.
Box with_ground(const Box& moving, std::vector<Box> grounds, bool falls) {
    const double size = larger_side(moving);
    const DVec2 reach{kNear * size, kNear * size};
    const Box near{moving.lower - DVec2{reach.x, falls ? kFarthestFall * size : reach.y}, moving.upper + reach};
    // Where a thing's edge is shown: at its end if that is near, else a little beyond what moves.
    const auto lower_end = [&](double end, double nearest, double edge) {
        return end >= nearest ? end : std::max(end, edge - kCut * size);
    };
    const auto upper_end = [&](double end, double farthest, double edge) {
        return end <= farthest ? end : std::min(end, edge + kCut * size);
    };
    std::stable_sort(grounds.begin(), grounds.end(),
                     [](const Box& a, const Box& b) { return a.upper.y > b.upper.y; });
    Box box = moving;
    for (const Box& ground : grounds) {
        const bool is_near = ground.lower.x <= near.upper.x && ground.upper.x >= near.lower.x &&
                             ground.lower.y <= near.upper.y && ground.upper.y >= near.lower.y;
        if (!is_near) continue;
        const bool is_below = ground.upper.y <= moving.lower.y + kSunk * size;
        const double bottom = is_below ? std::max(ground.lower.y, ground.upper.y - kGroundShown * size)
                                       : lower_end(ground.lower.y, moving.lower.y - reach.y, moving.lower.y);
        box.add({{lower_end(ground.lower.x, near.lower.x, moving.lower.x), bottom},
                 {upper_end(ground.upper.x, near.upper.x, moving.upper.x),
                  upper_end(ground.upper.y, near.upper.y, moving.upper.y)}});
        const bool stops_all = ground.lower.x <= moving.lower.x && ground.upper.x >= moving.upper.x;
        if (is_below && stops_all) break;
    }
    return box;
}

}  // namespace

Box interesting_box(const World& world, double aspect_ratio) {
    const Box moving = moving_box(world);
    const std::vector<Box> grounds = static_boxes(world);
    Box all = moving;
    for (const Box& ground : grounds) all.add(ground);
    if (moving.is_empty()) return all;
    const Box near = with_ground(moving, grounds, world.def().gravity.y < 0.0f);
    const bool has_room = height_for(all.size(), aspect_ratio) <= kRoomForAll * height_for(near.size(), aspect_ratio);
    return has_room ? all : near;
}

}  // namespace tumble::render
