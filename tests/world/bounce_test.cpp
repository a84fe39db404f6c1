// Restitution: heights, thresholds and head-on exchanges.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// How high the ball rises over its resting height after its first bounce.
double first_bounce_height(float restitution, double drop) {
    World world;
    add_floor(world, {.restitution = restitution});
    const BodyId ball = add_dynamic(world, {0.0, 0.5 + drop}, make_circle(0.5f), {.restitution = restitution});
    while (world.state(ball).velocity.y <= 0.0f) world.step();
    double highest = 0.0;
    while (world.state(ball).velocity.y > 0.0f) {
        highest = std::max(highest, world.state(ball).pose.position.y - 0.5);
        world.step();
    }
    return highest;
}

}  // namespace

TEST_CASE("a ball bounces to e^2 of the height") {
    for (const float e : {0.5f, 0.8f, 1.0f})
        for (const double drop : {1.0, 2.7, 5.0}) {
            CAPTURE(e);
            CAPTURE(drop);
            const double height = first_bounce_height(e, drop);
            CHECK(height == doctest::Approx(e * e * drop).epsilon(0.1));
        }
}

TEST_CASE("a slow approach does not bounce") {
    World world;
    add_floor(world, {.restitution = 1.0f});
    // Falling 3 cm gives 0.77 m/s, below the threshold of 1 m/s.
    const BodyId ball = add_dynamic(world, {0.0, 0.53}, make_circle(0.5f), {.restitution = 1.0f});
    run(world, 60);
    CHECK(std::abs(world.state(ball).velocity.y) < 1e-3);
    CHECK(std::abs(world.state(ball).pose.position.y - 0.5) < 1e-3);
}

TEST_CASE("equal balls that meet head-on exchange their velocities") {
    World world = weightless();
    const SurfaceMaterial bouncy{.restitution = 1.0f};
    const BodyId left = add_dynamic(world, {-2.0, 0.0}, make_circle(0.5f), bouncy);
    const BodyId right = add_dynamic(world, {2.0, 0.0}, make_circle(0.5f), bouncy);
    world.set_velocity(left, {3.0f, 0.0f}, 0.0f);
    world.set_velocity(right, {-2.0f, 0.0f}, 0.0f);
    run(world, 120);
    CHECK(world.state(left).velocity.x == doctest::Approx(-2.0).epsilon(1e-5));
    CHECK(world.state(right).velocity.x == doctest::Approx(3.0).epsilon(1e-5));
}

TEST_CASE("without restitution balls that meet go on together, momentum shared by mass") {
    World world = weightless();
    const BodyId heavy = add_dynamic(world, {-2.0, 0.0}, make_circle(0.5f), {.density = 3.0f});
    const BodyId light = add_dynamic(world, {2.0, 0.0}, make_circle(0.5f), {.density = 1.0f});
    world.set_velocity(heavy, {4.0f, 0.0f}, 0.0f);
    run(world, 120);
    CHECK(world.state(heavy).velocity.x == doctest::Approx(3.0).epsilon(1e-3));
    CHECK(world.state(light).velocity.x == doctest::Approx(3.0).epsilon(1e-3));
}
