// No step creates momentum or energy.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kGravity = 10.0;

DVec2 total_momentum(const World& world) {
    DVec2 sum;
    for (const BodyId id : world.bodies()) sum += double{world.mass(id).mass} * DVec2(world.state(id).velocity);
    return sum;
}

double kinetic_energy(const World& world) {
    double sum = 0.0;
    for (const BodyId id : world.bodies()) {
        const BodyMass mass = world.mass(id);
        const BodyState state = world.state(id);
        const double w = static_cast<double>(state.angular_velocity);
        sum += 0.5 * double{mass.mass} * length_sq(DVec2(state.velocity)) + 0.5 * double{mass.inertia} * w * w;
    }
    return sum;
}

// Potential energy is that above y = 0.
double total_energy(const World& world) {
    double sum = kinetic_energy(world);
    for (const BodyId id : world.bodies()) {
        const BodyMass mass = world.mass(id);
        sum += double{mass.mass} * kGravity * transform_point(world.state(id).pose, mass.center).y;
    }
    return sum;
}

// The scheme conserves the energy of a falling body at the velocity of the middle of the sub-step, v + g h / 2:
// see "a body in free fall follows the sum of the semi-implicit scheme".
double energy_of_scheme(const World& world, int substeps = 4) {
    return total_energy(world) - 0.5 * kGravity * total_momentum(world).y / (60.0 * substeps);
}

// Draws in a fixed order; the order of function arguments would be the compiler's choice.
Shape random_shape(std::mt19937& random) {
    std::uniform_real_distribution<float> size(0.2f, 0.6f);
    const float width = size(random), height = size(random);
    switch (random() % 3) {
        case 0: return make_circle(width);
        case 1: return make_box({2.0f * width, 2.0f * height});
        default: return make_capsule({-width, 0.0f}, {height, 0.0f}, 0.2f);
    }
}

}  // namespace

TEST_CASE("colliding bodies keep the sum of their momenta to rounding") {
    World world = weightless();
    std::mt19937 random(4);
    std::uniform_real_distribution<float> speed(-3.0f, 3.0f);
    double scale = 0.0;
    for (int i = 0; i < 25; ++i) {
        const DVec2 position{1.5 * (i % 5) - 3.0, 1.5 * (i / 5) - 3.0};
        const BodyId id = add_dynamic(world, position, random_shape(random), {.restitution = 0.3f});
        const Vec2 noise{speed(random), speed(random)};
        const Vec2 velocity = noise - to_float(position);  // towards the middle, where they collide
        world.set_velocity(id, velocity, speed(random));
        scale += double{world.mass(id).mass * length(velocity)};
    }
    const DVec2 before = total_momentum(world);
    int touching = 0;
    for (int step = 0; step < 180; ++step) {
        world.step();
        touching += world.counters().contacts;
    }
    CHECK(touching > 200);
    // In each of 180 * 4 sub-steps a body's velocity is rounded by a few passes over its contacts: 20 roundings of
    // 2^-24 of its momentum, of either sign.
    CHECK(length(total_momentum(world) - before) < 180 * 4 * 20 * 0x1p-24 * scale);
}

TEST_CASE("a passive scene never gains more than 1 % of energy in a minute") {
    World world;
    add_floor(world);
    add_static(world, {-5.5, 10.0}, make_box({1.0f, 20.0f}));
    add_static(world, {5.5, 10.0}, make_box({1.0f, 20.0f}));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> turn(-kPi, kPi);
    for (int i = 0; i < 40; ++i)
        add_dynamic(world, {-4.0 + 2.0 * (i % 5), 1.0 + 1.6 * (i / 5)}, random_shape(random), {}, turn(random));
    double lowest = total_energy(world);
    double largest_gain = 0.0;
    const double start = lowest;
    for (int step = 0; step < 3600; ++step) {
        world.step();
        const double now = total_energy(world);
        lowest = std::min(lowest, now);
        largest_gain = std::max(largest_gain, now - lowest);
    }
    CHECK(largest_gain < 0.01 * start);
    for (const BodyId id : world.bodies()) CHECK(world.state(id).pose.position.y > -1.1);  // nothing fell through
}

TEST_CASE("a box that bounces between walls with restitution 1 gains at most 1 % of energy in a minute") {
    for (const int substeps : {4, 8}) {
        CAPTURE(substeps);
        World world({.substeps = substeps, .sleeping = false});
        const SurfaceMaterial smooth{.friction = 0.0f, .restitution = 1.0f};
        add_floor(world, smooth);
        add_static(world, {-5.5, 20.0}, make_box({1.0f, 40.0f}), smooth);
        add_static(world, {5.5, 20.0}, make_box({1.0f, 40.0f}), smooth);
        const BodyId box = add_dynamic(world, {0.0, 4.0}, make_box({0.8f, 0.4f}), smooth, 0.7);
        const double start = energy_of_scheme(world, substeps);
        double highest = start, turned = 0.0;
        for (int step = 0; step < 3600; ++step) {
            world.step();
            highest = std::max(highest, energy_of_scheme(world, substeps));
            turned = std::max(turned, std::abs(double{world.state(box).angular_velocity}));
        }
        CHECK(turned > 3.0);  // the box tumbles
        CHECK(highest < 1.01 * start);
    }
}

// Spinning boxes and capsules hit a floor with two corners in one step, or are stopped by continuous collision after a
// bounce: neither may create energy. With friction, the impulse that stops slip must not become a bounce.
TEST_CASE("no single body with restitution 1 gains more than 1 % of energy in a minute") {
    int spinning = 0;
    for (const float friction : {0.0f, 0.3f, 0.6f}) {
        const SurfaceMaterial hard{.friction = friction, .restitution = 1.0f};
        for (unsigned seed = 251; seed <= 350; ++seed) {
            CAPTURE(friction);
            CAPTURE(seed);
            std::mt19937 random(seed);
            std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
            World world({.sleeping = false});
            add_floor(world, hard);
            add_static(world, {-5.5, 20.0}, make_box({1.0f, 40.0f}), hard);
            add_static(world, {5.5, 20.0}, make_box({1.0f, 40.0f}), hard);
            const Shape shape = random_shape(random);
            const BodyId body = add_dynamic(world, {0.0, 4.0}, shape, hard, 3.0 * static_cast<double>(unit(random)));
            const float right = 8.0f * unit(random), up = 8.0f * unit(random), spin = 30.0f * unit(random);
            world.set_velocity(body, {right, up}, spin);
            const double start = energy_of_scheme(world);
            double highest = start;
            bool spins = false;
            for (int step = 0; step < 3600; ++step) {
                world.step();
                highest = std::max(highest, energy_of_scheme(world));
                spins =
                    spins || std::abs(world.state(body).angular_velocity) > 25.0f;  // an eighth of a turn in two steps
            }
            spinning += spins;
            CHECK(highest < 1.01 * start);
        }
    }
    CHECK(spinning > 90);  // of 300
    CHECK(spinning < 210);
}

// A box that flies into a corner stands on the floor while the wall rotates it: each contact pushes it into the other.
// The energy that one contact absorbs comes in part from the other. If each returned all of its own, half of these
// boxes would gain up to 4.4 %.
TEST_CASE("a bounce between floor and wall returns no more energy than both contacts absorbed") {
    const SurfaceMaterial smooth{.friction = 0.0f, .restitution = 1.0f};
    for (int i = 0; i < 2 * 21 * 21; ++i) {
        const ImpactModel impacts = i % 2 == 0 ? ImpactModel::in_order : ImpactModel::at_step_end;
        const int speed = i / 2 / 21, turn = i / 2 % 21;
        CAPTURE(speed);
        CAPTURE(turn);
        World world({.gravity = {}, .sleeping = false, .impacts = impacts});
        add_floor(world, smooth);
        add_static(world, {-5.5, 20.0}, make_box({1.0f, 40.0f}), smooth);
        const BodyId box = add_dynamic(world, {-4.55, 0.273}, make_box({0.48f, 0.88f}), smooth, -1.534 + 0.01 * turn);
        world.set_velocity(box, {-11.7f + 0.2f * static_cast<float>(speed), 2.76f}, -5.1f);
        const double start = kinetic_energy(world);
        int contacts = 0;
        std::size_t begins = 0;
        for (int step = 0; step < 4; ++step) {
            world.step();
            CHECK(kinetic_energy(world) < 1.0001 * start);
            contacts = std::max(contacts, world.counters().contacts);
            begins += world.events().contact_begins.size();
        }
        CHECK(begins >= 1);
        if (impacts == ImpactModel::at_step_end) CHECK(contacts == 2);
    }
}

// A body that hits two others at once has to separate from each at its approach speed, which may need more energy than
// both impacts absorbed.
TEST_CASE("ten bodies that collide with restitution 1 gain at most 1 % of energy in a minute") {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        World world({.sleeping = false});
        const SurfaceMaterial smooth{.friction = 0.0f, .restitution = 1.0f};
        add_floor(world, smooth);
        add_static(world, {-5.5, 20.0}, make_box({1.0f, 40.0f}), smooth);
        add_static(world, {5.5, 20.0}, make_box({1.0f, 40.0f}), smooth);
        for (int i = 0; i < 10; ++i) {
            const BodyId id =
                add_dynamic(world, {-4.0 + 2.0 * (i % 5), 2.0 + 2.0 * (i / 5)}, random_shape(random), smooth);
            world.set_velocity(id, {3.0f - static_cast<float>(i), 2.0f}, static_cast<float>(i - 5));
        }
        const double start = energy_of_scheme(world);
        double highest = start;
        for (int step = 0; step < 3600; ++step) {
            world.step();
            highest = std::max(highest, energy_of_scheme(world));
        }
        CHECK(highest < 1.01 * start);
    }
}

// Joints that swing, slide, roll and spring, none of them damped or driven.
TEST_CASE("machines without motors never gain more than 1 % of energy in a minute") {
    World world({.sleeping = false});
    const BodyId frame = world.create_body({.type = BodyType::static_body});
    const BodyId upper = add_dynamic(world, {1.0, 5.0}, make_box({2.0f, 0.2f}));
    const BodyId lower = add_dynamic(world, {3.0, 5.0}, make_box({2.0f, 0.2f}));
    world.create_joint(
        RevoluteJointDef{.body_a = frame, .body_b = upper, .anchor_a = {0.0f, 5.0f}, .anchor_b = {-1.0f, 0.0f}});
    world.create_joint(
        RevoluteJointDef{.body_a = upper, .body_b = lower, .anchor_a = {1.0f, 0.0f}, .anchor_b = {-1.0f, 0.0f}});
    const BodyId slider = add_dynamic(world, {-4.0, 5.0}, make_box({0.5f, 0.5f}));
    const BodyId hung = add_dynamic(world, {-4.0, 3.0}, make_circle(0.3f));
    world.create_joint(PrismaticJointDef{.body_a = frame,
                                         .body_b = slider,
                                         .anchor_a = {-4.0f, 5.0f},
                                         .limits = JointLimits{-1.0f, 1.0f},
                                         .spring = JointSpring{0.5f, 0.0f}});
    world.create_joint(DistanceJointDef{.body_a = slider, .body_b = hung, .length = 2.0f});
    world.set_velocity(hung, {4.0f, 0.0f}, 0.0f);
    const BodyId wheel = add_dynamic(world, {8.0, 4.0}, make_circle(0.5f));
    world.create_joint(
        WheelJointDef{.body_a = frame, .body_b = wheel, .anchor_a = {8.0f, 5.0f}, .spring = JointSpring{1.0f, 0.0f}});
    const auto spring_energy = [&](BodyId body, DVec2 rest, DVec2 axis, double hertz) {
        const double displacement = dot(world.state(body).pose.position - rest, axis), omega = 2.0 * kPi * hertz;
        return 0.5 * double{world.mass(body).mass} * omega * omega * displacement * displacement;
    };
    const auto energy = [&] {
        return total_energy(world) + spring_energy(slider, {-4.0, 5.0}, {1.0, 0.0}, 0.5) +
               spring_energy(wheel, {8.0, 5.0}, {0.0, 1.0}, 1.0);
    };
    // The lowest reachable energy: all hang straight down, the wheel g / w^2 below its suspension.
    const auto weight = [&](BodyId body) { return kGravity * double{world.mass(body).mass}; };
    const double sag = kGravity / std::pow(2.0 * kPi * 1.0, 2.0);
    const double least = 4.0 * weight(upper) + 2.0 * weight(lower) + 5.0 * weight(slider) + 3.0 * weight(hung) +
                         (5.0 - 0.5 * sag) * weight(wheel);
    double lowest = energy(), gain = 0.0;
    const double start = lowest - least;
    for (int step = 0; step < 3600; ++step) {
        world.step();
        lowest = std::min(lowest, energy());
        gain = std::max(gain, energy() - lowest);
    }
    CAPTURE(gain);
    CHECK(start > 0.0);
    CHECK(gain < 0.01 * start);
}
