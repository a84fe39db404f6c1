// Friction, rolling resistance and belts against Coulomb's law.
#include <doctest/doctest.h>

#include <cmath>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kGravity = 10.0;
constexpr double kH = 1.0 / 240.0;
constexpr double kDegree = kPi / 180.0;

// A flat box on a slope that falls to the right; how far it has slid along it after `steps`.
double slide(double slope, float friction, int steps) {
    World world({.sleeping = false});  // it starts slower than what counts as rest
    const SurfaceMaterial material{.friction = friction};
    add_static(world, {}, make_box({100.0f, 2.0f}), material, -slope);
    const DVec2 up{std::sin(slope), std::cos(slope)}, down{std::cos(slope), -std::sin(slope)};
    const BodyId box = add_dynamic(world, 1.25 * up, make_box({2.0f, 0.5f}), material, -slope);
    run(world, steps);
    return dot(world.state(box).pose.position - 1.25 * up, down);
}

}  // namespace

TEST_CASE("a box slides from the angle whose tangent is the friction on, within half a degree") {
    for (const float friction : {0.2f, 0.6f, 1.0f}) {
        const double critical = std::atan(friction);
        // Below: friction begins one sub-step late, when the normal impulse is known. The speed g sin h gained until
        // then is lost at the rate g (mu cos - sin).
        const double under = critical - 0.5 * kDegree;
        const double speed = kGravity * std::sin(under) * kH;
        const double braking = kGravity * (friction * std::cos(under) - std::sin(under));
        CHECK(std::abs(slide(under, friction, 120)) < speed * speed / (2.0 * braking) + 1e-4);
        // Above: it slides by (a t^2) / 2 with a = g (sin - mu cos), and by as much more as it gains in the sub-step
        // that friction begins late, g sin h t.
        const double slope = critical + 0.5 * kDegree;
        const double expected = kGravity * (std::sin(slope) - friction * std::cos(slope)) * 4.0 / 2.0;
        const double slid = slide(slope, friction, 120);
        CHECK(slid > 0.99 * expected);
        CHECK(slid < expected + kGravity * std::sin(slope) * kH * 2.0);
    }
}

TEST_CASE("the friction of a pair is the root of the product") {
    World world;
    add_floor(world, {.friction = 0.9f});
    const BodyId box = add_dynamic(world, {0.0, 0.25}, make_box({2.0f, 0.5f}), {.friction = 0.4f});
    world.set_velocity(box, {4.0f, 0.0f}, 0.0f);
    // sqrt(0.36) = 0.6. The box sinks into the floor until its contacts carry its weight: the braking differs from mu g
    // by 1.4 % at first, and by a quarter less after each step, 5e-5 of it after 20.
    run(world, 20);
    const float before = world.state(box).velocity.x;
    run(world, 18);
    CHECK(near(before - world.state(box).velocity.x, 0.6 * kGravity * 18.0 / 60.0, relative(5e-5)));
}

TEST_CASE("a sliding box stops after v^2 / (2 mu g)") {
    World world;
    add_floor(world, {.friction = 0.5f});
    const BodyId box = add_dynamic(world, {0.0, 0.125}, make_box({4.0f, 0.25f}), {.friction = 0.5f});
    world.set_velocity(box, {5.0f, 0.0f}, 0.0f);
    run(world, 120);
    // The scheme moves with the velocity at the end of each sub-step: v h / 2 less, and one sub-step more or less.
    const double expected = 25.0 / (2.0 * 0.5 * kGravity);
    CHECK(std::abs(world.state(box).pose.position.x - expected) < 5.0 * kH * 1.5);
    CHECK(std::abs(world.state(box).velocity.x) < 1e-4);
}

TEST_CASE("a rolling ball stops after 3 v^2 / (4 c g) under the rolling resistance c") {
    World world;
    constexpr float c = 0.1f, v = 2.0f, radius = 0.5f;
    add_floor(world);
    const BodyId ball = add_dynamic(world, {0.0, radius}, make_circle(radius), {.rolling_resistance = c});
    world.set_velocity(ball, {v, 0.0f}, -v / radius);
    // The torque c r m g slows a disc (I = m r^2 / 2) that rolls without slipping by a = (2/3) c g: v / a = 3 s.
    run(world, 30);
    const float before = world.state(ball).velocity.x;
    run(world, 60);
    CHECK(near(before - world.state(ball).velocity.x, 2.0 / 3.0 * double{c} * kGravity, relative(5e-5)));
    run(world, 150);
    // The scheme moves with the velocity at the end of each sub-step: v h / 2 less, and one sub-step more or less.
    const double expected = 3.0 * v * v / (4.0 * c * kGravity);
    CHECK(near(world.state(ball).pose.position.x, expected, absolute(1.5 * double{v} * kH)));
    CHECK(std::abs(world.state(ball).angular_velocity) < 1e-3);
}

TEST_CASE("a ball without rolling resistance does not slow down") {
    World world;
    add_floor(world);
    const BodyId ball = add_dynamic(world, {0.0, 0.5}, make_circle(0.5f));
    world.set_velocity(ball, {2.0f, 0.0f}, -4.0f);
    run(world, 600);
    // While the ball settles into the floor its contact carries up to twice its weight, on an arm that is rounded.
    CHECK(near(world.state(ball).velocity.x, 2.0, float_sum(4 * 600)));
}

TEST_CASE("a belt carries to the left at its tangent speed, whichever body was created first") {
    for (const bool belt_first : {true, false}) {
        World world;
        const SurfaceMaterial belt{.tangent_speed = 2.0f};
        if (belt_first) add_floor(world, belt);
        const BodyId box = add_dynamic(world, {0.0, 0.125}, make_box({2.0f, 0.25f}));
        if (!belt_first) add_floor(world, belt);
        run(world, 12);
        // Speeding up at mu g = 6 m/s^2 for 0.2 s, less the sub-step before the first normal impulse is known.
        const float after_12 = world.state(box).velocity.x;
        CHECK(after_12 > -1.2f);
        CHECK(after_12 < -1.2f + 6.0f / 240.0f);
        // The contact has settled into the floor to 7e-4 of the box's weight, and to a quarter of that 5 steps later.
        run(world, 6);
        CHECK(near(world.state(box).velocity.x - after_12, -6.0 * 6.0 / 60.0, relative(7e-4)));
        run(world, 102);
        CHECK(near(world.state(box).velocity.x, -2.0, kFloat));
    }
}

TEST_CASE("friction gives a landing disc a spin that rolls, never the opposite one") {
    for (const ImpactModel model : {ImpactModel::in_order, ImpactModel::at_step_end})
        for (const float radius : {0.05f, 0.1f, 0.2f, 0.5f})
            for (const float restitution : {0.0f, 0.01f, 0.5f}) {
                CAPTURE(radius);
                CAPTURE(restitution);
                WorldDef def;
                def.impacts = model;
                World world(def);
                const SurfaceMaterial material{.friction = 0.3f, .restitution = restitution};
                add_floor(world, material);
                const BodyId disc = add_dynamic(world, {0.0, radius + 3.0}, make_circle(radius), material);
                world.set_velocity(disc, {25.0f, -25.0f}, 0.0f);
                for (int step = 0; step < 30; ++step) {
                    world.step();
                    const BodyState state = world.state(disc);
                    CHECK(state.angular_velocity <= 0.0f);  // clockwise, as it moves to the right
                    CHECK(-state.angular_velocity * radius <= state.velocity.x * 1.001f);
                }
            }
}
