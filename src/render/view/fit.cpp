#include "render/view/fit.hpp"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "debug/check.hpp"

namespace tumble::render {
namespace {

// Lengths in units of the larger side of the box around all moving bodies, the moving box.
constexpr double kNear = 1.0;           // a static shape that ends within this beside or above the box is shown whole
constexpr double kSmall = 1.0;          // so is a static body of at most this size that begins within kNear
constexpr double kCut = 0.1;            // longer static shapes are shown this far beyond the box
constexpr double kGroundShown = 0.06;   // thick ground is shown this far below its top
constexpr double kSunk = 0.02;          // a body may overlap its ground or its room by this
constexpr double kFarthestFall = 40.0;  // ground is searched this far below
constexpr double kLargestRoom = 24.0;   // a static body of at most this size is a room for what stays in its box

// Factors on the height of the frame.
constexpr double kGrowthForStatics = 1.75;  // at most, to show all static shapes
constexpr double kGrowthForMotion = 3.0;    // at most, to show the motions, from the frame fitted to the start

Box moving_box(const World& world) {
    Box box;
    for (const BodyId body : world.bodies()) {
        if (world.type(body) == BodyType::static_body) continue;
        box.add(box_of(world, body));
        if (world.state(body).angular_velocity != 0.0f) box.add(swept_box(world, body, world.mass(body).center));
    }
    // Hinged bodies turn about their hinges, and the ropes of pulleys run up to their wheels.
    for (const JointId id : world.joints()) {
        if (const auto* pulley = std::get_if<PulleyJointDef>(&world.joint(id))) {
            box.add({pulley->ground_anchor_a, pulley->ground_anchor_a});
            box.add({pulley->ground_anchor_b, pulley->ground_anchor_b});
        }
        const auto* hinge = std::get_if<RevoluteJointDef>(&world.joint(id));
        if (!hinge) continue;
        if (world.type(hinge->body_a) != BodyType::static_body)
            box.add(swept_box(world, hinge->body_a, hinge->anchor_a));
        if (world.type(hinge->body_b) != BodyType::static_body)
            box.add(swept_box(world, hinge->body_b, hinge->anchor_b));
    }
    return box;
}

// The bounds of a static shape and of its whole body.
struct Fixture {
    Box box;
    Box body;
    bool is_solid = true;
};

std::vector<Fixture> fixtures_of(const World& world) {
    std::vector<Fixture> fixtures;
    for (const BodyId body : world.bodies()) {
        if (world.type(body) != BodyType::static_body) continue;
        const Pose pose = world.state(body).pose;
        const Box whole = box_of(world, body);
        for (const ShapeId shape : world.shapes(body))
            if (const Box box = box_of(world.shape(shape), pose); !box.is_empty())
                fixtures.push_back({box, whole, !world.is_sensor(shape)});
    }
    return fixtures;
}

// The moving box, grown downwards to the ground that it may fall on and sideways by the static shapes near it.
Box with_ground(const Box& moving, std::vector<Fixture> grounds, bool falls) {
    const double size = moving.larger_side();
    const DVec2 reach{kNear * size, kNear * size};
    const Box near{moving.lower - DVec2{reach.x, falls ? kFarthestFall * size : reach.y}, moving.upper + reach};
    // A side of a static shape as shown: at its true end if that is near, else a little beyond the moving box.
    const auto lower_end = [&](double end, double nearest, double edge) {
        return end >= nearest ? end : std::max(end, edge - kCut * size);
    };
    const auto upper_end = [&](double end, double farthest, double edge) {
        return end <= farthest ? end : std::min(end, edge + kCut * size);
    };
    std::stable_sort(grounds.begin(), grounds.end(),
                     [](const Fixture& a, const Fixture& b) { return a.box.upper.y > b.box.upper.y; });
    Box box = moving;
    for (const auto& [ground, body, is_solid] : grounds) {
        const bool is_near = ground.lower.x <= near.upper.x && ground.upper.x >= near.lower.x &&
                             ground.lower.y <= near.upper.y && ground.upper.y >= near.lower.y;
        if (!is_near) continue;
        if (body.larger_side() <= kSmall * size) box.add(body);
        const bool is_below = ground.upper.y <= moving.lower.y + kSunk * size;
        const double bottom = is_below ? std::max(ground.lower.y, ground.upper.y - kGroundShown * size)
                                       : lower_end(ground.lower.y, moving.lower.y - reach.y, moving.lower.y);
        box.add({{lower_end(ground.lower.x, near.lower.x, moving.lower.x), bottom},
                 {upper_end(ground.upper.x, near.upper.x, moving.upper.x),
                  upper_end(ground.upper.y, near.upper.y, moving.upper.y)}});
        const bool stops_all = ground.lower.x <= moving.lower.x && ground.upper.x >= moving.upper.x;
        if (is_solid && is_below && stops_all) break;
    }
    return box;
}

// The moving box with its ground, or with all static shapes if they fit.
Box shown_box(const Box& moving, const std::vector<Fixture>& fixtures, bool falls, double aspect_ratio) {
    Box all = moving;
    for (const Fixture& fixture : fixtures) all.add(fixture.box);
    if (moving.is_empty()) return all;
    const Box near = with_ground(moving, fixtures, falls);
    const bool has_room =
        height_for(all.size(), aspect_ratio) <= kGrowthForStatics * height_for(near.size(), aspect_ratio);
    return has_room ? all : near;
}

// The moving box at the start of the motions, shown with its static shapes.
Box box_at_start(const World& world, Box moving, const std::vector<MotionBounds>& motions, double aspect_ratio) {
    for (const MotionBounds& motion : motions) moving.add(motion.start);
    return shown_box(moving, fixtures_of(world), world.def().gravity.y < 0.0f, aspect_ratio);
}

// The static bodies that are small enough to be shown with what moves in them, such as a rink with its puck. Sensors
// alone are no room. What rests on the floor or hits a wall overlaps it a little.
std::vector<Box> rooms_of(const World& world) {
    const double size = moving_box(world).larger_side();
    const DVec2 overlap{kSunk * size, kSunk * size};
    std::vector<Box> rooms;
    for (const auto& [shape, body, is_solid] : fixtures_of(world))
        if (is_solid && body.larger_side() <= kLargestRoom * size)
            rooms.push_back({body.lower - overlap, body.upper + overlap});
    return rooms;
}

bool stays_in(const std::vector<Box>& rooms, const MotionBounds& motion) {
    return std::ranges::any_of(rooms, [&](const Box& room) { return room.contains(motion.whole); });
}

// The largest frame that motions may ask for.
Box farthest_frame(const Box& start, double aspect_ratio) {
    const double reach = 0.5 * kGrowthForMotion * height_for(start.size(), aspect_ratio);
    const DVec2 half{aspect_ratio * reach, reach};
    return {start.center() - half, start.center() + half};
}

}  // namespace

Box fitted_box(const World& world, const std::vector<MotionBounds>& motions, double aspect_ratio) {
    TUMBLE_CHECK(aspect_ratio > 0.0);
    Box moving = moving_box(world);
    const Box start = box_at_start(world, moving, motions, aspect_ratio);
    if (start.is_empty() || motions.empty()) return start;
    const Box farthest = farthest_frame(start, aspect_ratio);
    const std::vector<Box> rooms = rooms_of(world);
    for (const MotionBounds& motion : motions) {
        moving.add(motion.start);
        if (farthest.contains(motion.whole) || stays_in(rooms, motion)) moving.add(motion.whole);
    }
    return shown_box(moving, fixtures_of(world), world.def().gravity.y < 0.0f, aspect_ratio);
}

std::optional<MotionBounds> leading_motion(const World& world, const std::vector<MotionBounds>& motions,
                                           double aspect_ratio) {
    if (motions.empty()) return std::nullopt;
    const Box farthest = farthest_frame(box_at_start(world, moving_box(world), motions, aspect_ratio), aspect_ratio);
    const std::vector<Box> rooms = rooms_of(world);
    std::optional<MotionBounds> leader;
    std::size_t driven = 0;
    for (const MotionBounds& motion : motions) {
        const DVec2 path = motion.whole.size() - motion.start.size();
        if (farthest.contains(motion.whole) || path.x <= path.y || stays_in(rooms, motion)) continue;
        ++driven;
        if (!leader || motion.start.larger_side() > leader->start.larger_side()) leader = motion;
    }
    return 2 * driven >= motions.size() ? leader : std::nullopt;
}

}  // namespace tumble::render
