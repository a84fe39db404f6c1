// Hinges and rods that are the only joint of their bodies, which the default solver solves exactly. Pendulums are
// tested beside those of the direct solver, in direct_test.cpp.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr int kMinute = 3600;  // steps

double kinetic_energy(const World& world, BodyId id) {
    const BodyState state = world.state(id);
    const DVec2 velocity(state.velocity);
    const double spin = state.angular_velocity;
    return 0.5 * double{world.mass(id).mass} * dot(velocity, velocity) +
           0.5 * double{world.mass(id).inertia} * spin * spin;
}

// A bar of 1 m that hangs on a hinge, seen from the side of its centre.
BodyId hang_bar(World& world, BodyId from, Vec2 anchor, DVec2 center) {
    const BodyId bar = add_dynamic(world, center, make_box({1.0f, 0.1f}));
    world.create_joint(RevoluteJointDef{.body_a = from, .body_b = bar, .anchor_a = anchor, .anchor_b = {-0.5f, 0.0f}});
    return bar;
}

}  // namespace

// The chord keeps the speed on a circle (JOINT_SYSTEM.md, step 6). Each of 4 sub-steps of 3600 steps rounds the
// velocities in three passes by 2^-24.
TEST_CASE("two balls on a rod, and two bars on a hinge, rotate for a minute without a loss") {
    constexpr double kRounding = 2.0 * 4 * 3 * kMinute * 0x1p-24;  // of the square of a speed
    for (const bool is_rod : {true, false}) {
        CAPTURE(is_rod);
        World world({.gravity = {}, .sleeping = false});
        const Shape shape = is_rod ? make_circle(0.2f) : make_box({1.0f, 0.1f});
        const BodyId left = add_dynamic(world, {-0.5, 0.0}, shape), right = add_dynamic(world, {0.5, 0.0}, shape);
        if (is_rod)
            world.create_joint(DistanceJointDef{.body_a = left, .body_b = right, .length = 1.0f});
        else
            world.create_joint(
                RevoluteJointDef{.body_a = left, .body_b = right, .anchor_a = {0.5f, 0.0f}, .anchor_b = {-0.5f, 0.0f}});
        world.set_velocity(left, {0.0f, -4.0f}, 8.0f);
        world.set_velocity(right, {0.0f, 4.0f}, 8.0f);
        const double before = kinetic_energy(world, left) + kinetic_energy(world, right);
        run(world, kMinute);
        CHECK(near(kinetic_energy(world, left) + kinetic_energy(world, right), before, relative(kRounding)));
        CHECK(near(length(world.state(right).pose.position - world.state(left).pose.position), 1.0, absolute(1e-4)));
    }
}

// A joint that only switches off collision does not act on the bodies: bit for bit as without it.
TEST_CASE("a hinge or rod whose bodies have a joint without rows moves as the only joint of its bodies") {
    const auto positions = [](bool is_rod, bool is_held, bool has_filter) {
        World world({.sleeping = false});
        const BodyId held = add_static(world, {0.0, 0.0}, make_circle(0.01f));
        const BodyId free = add_dynamic(world, {0.0, 0.0}, make_box({1.0f, 0.1f}));
        const BodyId bar = add_dynamic(world, {2.0, 0.0}, make_box({1.0f, 0.1f}));
        const BodyId far = add_dynamic(world, {100.0, 0.0}, make_circle(1.0f));
        const BodyId from = is_held ? held : free;
        if (has_filter) world.create_joint(FilterJointDef{.body_a = bar, .body_b = far});
        if (is_rod)
            world.create_joint(DistanceJointDef{.body_a = from, .body_b = bar, .length = 2.0f});
        else
            world.create_joint(
                RevoluteJointDef{.body_a = from, .body_b = bar, .anchor_a = {1, 0}, .anchor_b = {-1, 0}});
        world.set_velocity(bar, {0.0f, 3.0f}, 5.0f);
        run(world, 60);
        return std::vector<DVec2>{world.state(bar).pose.position, world.state(free).pose.position};
    };
    for (const bool is_rod : {true, false})
        for (const bool is_held : {true, false}) {
            CAPTURE(is_rod);
            CAPTURE(is_held);
            CHECK(positions(is_rod, is_held, true) == positions(is_rod, is_held, false));
        }
}

// A pendulum that carries four more bars loses energy to the softness of the joints. Without them it must keep it.
TEST_CASE("a joint is exact from the step in which it becomes the only one of its bodies") {
    World world({.sleeping = false});
    const BodyId pivot = add_static(world, {0.0, 0.0}, make_circle(0.01f));
    const BodyId upper = hang_bar(world, pivot, {}, {0.5, 0.0});
    std::vector<BodyId> chain = {upper};
    while (chain.size() < 5)
        chain.push_back(hang_bar(world, chain.back(), {0.5f, 0.0f}, {0.5 + static_cast<double>(chain.size()), 0.0}));
    const auto energy = [&] {
        const double mass = double{world.mass(upper).mass};
        return kinetic_energy(world, upper) + mass * 10.0 * (world.state(upper).pose.position.y + 0.5);
    };
    run(world, 30);
    for (std::size_t i = 1; i < chain.size(); ++i) world.destroy_body(chain[i]);
    world.set_transform(upper, {{0.5, 0.0}, {}});
    world.set_velocity(upper, {}, 0.0f);
    // A step shows positions and velocities half a sub-step of gravity apart; the mean of 5 s does not.
    const auto mean_energy = [&] {
        double sum = 0.0;
        for (int step = 0; step < 300; ++step) {
            world.step();
            sum += energy();
        }
        return sum / 300.0;
    };
    const double before = mean_energy();
    run(world, kMinute);
    CHECK(near(mean_energy(), before, relative(1e-3)));
}
