// Floors of several shapes: who slides over a seam between two of them does not feel it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

struct Ride {
    double highest = 0.0;       // over where it lay, m
    double fastest_rise = 0.0;  // m/s
    double most_turned = 0.0;   // radians
    float speed = 0.0f;         // at the end
};

Ride ride(const Shape& shape, double height, float speed) {
    World world({.sleeping = false});
    const SurfaceMaterial smooth{.friction = 0.0f};
    for (int i = 0; i < 60; ++i) add_static(world, {i - 5.0, -0.5}, make_box({1.0f, 1.0f}), smooth);
    const BodyId body = add_dynamic(world, {0.0, height}, shape, smooth);
    run(world, 60);
    const double rest = world.state(body).pose.position.y;
    world.set_velocity(body, {speed, 0.0f}, 0.0f);
    Ride found;
    const int steps = static_cast<int>(45.0f / speed * 60.0f);
    for (int step = 0; step < steps; ++step) {
        world.step();
        const BodyState state = world.state(body);
        found.highest = std::max(found.highest, state.pose.position.y - rest);
        found.fastest_rise = std::max(found.fastest_rise, double{state.velocity.y});
        found.most_turned = std::max(found.most_turned, std::abs(angle(state.pose.rotation)));
        found.speed = state.velocity.x;
    }
    return found;
}

}  // namespace

TEST_CASE("who slides over tiles is neither lifted nor turned nor slowed by their seams") {
    const struct {
        std::string name;
        Shape shape;
        double height;
    } bodies[] = {{"box", make_box({1.2f, 0.5f}), 0.25},
                  {"rounded box", make_box({1.2f, 0.5f}, 0.1f), 0.25},
                  {"ball", make_circle(0.25f), 0.25},
                  {"capsule", make_capsule({-0.3f, 0.0f}, {0.3f, 0.0f}, 0.2f), 0.2}};
    for (const auto& body : bodies)
        for (const float speed : {2.0f, 10.0f, 25.0f}) {
            const Ride found = ride(body.shape, body.height, speed);
            INFO(body.name, " at ", speed, ": rise ", found.highest, " speed ", found.fastest_rise, " turn ",
                 found.most_turned, " speed ", found.speed);
            CHECK(found.highest < 1e-4);
            CHECK(found.fastest_rise < 1e-3);
            CHECK(found.most_turned < 2e-4);
            CHECK(found.speed > 0.9999f * speed);
        }
}
