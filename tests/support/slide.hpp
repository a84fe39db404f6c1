// A body that slides along the x axis without friction, and how the ground disturbs it.
#pragma once

#include <algorithm>
#include <cmath>

#include "support/worlds.hpp"

namespace tumble::test {

// Metres that a body may rise and sink. If it is on another segment in each step, new impulses alone carry it, and for
// those a contact yields four times as far as its spring would: 4 x 1.25 g / w^2 for a box, w = 2 pi 60 / s on a static
// body.
inline constexpr double kDeepestSlide = 4.0 * 1.25 * 10.0 / (4.0 * kPi * kPi * 60.0 * 60.0);

struct Slide {
    double highest_rise = 0.0;  // of the body above or below its rest height, m
    double fastest_rise = 0.0;  // up or down, m/s
    double most_turned = 0.0;   // radians
    double slowest = 1e9;       // m/s along the ground
};

// Rests for a second at `start`, then slides.
inline Slide slide(World& world, const Shape& shape, DVec2 start, float speed, int steps) {
    SurfaceMaterial smooth;
    smooth.friction = 0.0f;
    const BodyId body = add_dynamic(world, start, shape, smooth);
    run(world, 60);
    const double rest = world.state(body).pose.position.y;
    world.set_velocity(body, {speed, 0.0f}, 0.0f);
    Slide found;
    for (int step = 0; step < steps; ++step) {
        world.step();
        const BodyState state = world.state(body);
        found.highest_rise = std::max(found.highest_rise, std::abs(state.pose.position.y - rest));
        found.fastest_rise = std::max<double>(found.fastest_rise, std::abs(state.velocity.y));
        found.most_turned = std::max(found.most_turned, std::abs(angle(state.pose.rotation)));
        found.slowest = std::min<double>(found.slowest, state.velocity.x);
    }
    return found;
}

}  // namespace tumble::test
