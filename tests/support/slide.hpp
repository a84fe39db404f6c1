// A body that slides along the x axis without friction, and what it feels of the ground.
#pragma once

#include <algorithm>
#include <cmath>

#include "support/worlds.hpp"

namespace tumble::test {

// Who is on another segment in every step is borne by new impulses alone, on which a contact gives way four times as
// far as its spring would: 4 x 1.25 g / w^2 for a box, w = 2 pi 60 / s against what is static. That is how far it may
// rise and sink.
inline constexpr double kDeepestSlide = 4.0 * 1.25 * 10.0 / (4.0 * kPi * kPi * 60.0 * 60.0);

struct Slide {
    double highest_rise = 0.0;  // of the body above or below where it lay, m
    double fastest_rise = 0.0;  // up or down, m/s
    double most_turned = 0.0;   // radians
    double slowest = 1e9;       // m/s along the ground
};

// Lies down for a second at `start`, then slides.
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
