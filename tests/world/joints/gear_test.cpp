// Gear joints: ratios, torques, rack and pinion.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/geared_wheels.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kGravity = 10.0;
constexpr double kRounding = 240 * 20 * 0x1p-24;  // of velocities, a second of sub-steps with 20 roundings in each

// An impulse P on A and r P on B: w_A = w + P / I_A = -r w_B = -r^2 P / I_B.
double speed_of_b(double w, double inertia_a, double inertia_b, double r) {
    return -r * inertia_a * w / (inertia_b + r * r * inertia_a);
}

double angular_momentum(const World& world) {
    double sum = 0.0;
    for (const BodyId id : world.bodies()) {
        const BodyState state = world.state(id);
        const BodyMass mass = world.mass(id);
        sum += double{mass.inertia} * double{state.angular_velocity} +
               double{mass.mass} * cross(state.pose.position, DVec2(state.velocity));
    }
    return sum;
}

}  // namespace

TEST_CASE("geared wheels rotate at -1 / ratio") {
    for (const float ratio : {2.0f, -1.0f, 0.25f}) {
        CAPTURE(ratio);
        Wheels wheels(weightless(), BodyType::static_body, ratio);
        wheels.world.set_velocity(wheels.a, {}, 6.0f);
        run(wheels.world, 60);
        const double expected = speed_of_b(6.0, 2.0, 32.0, double{ratio});
        CHECK(std::abs(wheels.speed(wheels.b) - expected) < kRounding * 6.0);
        CHECK(std::abs(wheels.speed(wheels.a) + double{ratio} * expected) < kRounding * 6.0);
    }
}

// Of ratio 2, so that whole turns of B are whole turns of the sum.
TEST_CASE("a gear keeps its constraint over hundreds of turns") {
    Wheels wheels(weightless(), BodyType::static_body, 2.0f);
    wheels.world.set_velocity(wheels.a, {}, 40.0f);
    wheels.world.set_velocity(wheels.b, {}, -20.0f);
    double worst = 0.0;
    for (int step = 0; step < 3600; ++step) {
        wheels.world.step();
        worst = std::max(worst,
                         std::abs(std::remainder(wheels.turned(wheels.a) + 2.0 * wheels.turned(wheels.b), 2.0 * kPi)));
    }
    CHECK(wheels.speed(wheels.a) * 60.0 > 300.0 * 2.0 * kPi);
    CHECK(worst < 1e-4);
    CHECK(std::abs(wheels.world.joint_position(wheels.gear)) < 1e-4f);
}

// 250 rad/s are 4.2 rad a step, more than half a turn; in a sub-step small_rotation() errs by 0.26^5 / 120 = 1e-5 rad.
TEST_CASE("a gear keeps its constraint on wheels with allow_fast_rotation") {
    Wheels wheels(World(WorldDef{.gravity = {}, .substeps = 16}), BodyType::static_body, 2.5f);
    wheels.world.set_allow_fast_rotation(wheels.a, true);
    wheels.world.set_allow_fast_rotation(wheels.b, true);
    wheels.world.set_velocity(wheels.a, {}, 250.0f);
    wheels.world.set_velocity(wheels.b, {}, -100.0f);
    run(wheels.world, 120);
    CHECK(near(wheels.speed(wheels.a), 250.0, kFloat));
    CHECK(std::abs(wheels.world.joint_position(wheels.gear)) < 1e-3f);
}

// I_A a_A = T_A + P and I_B a_B = T_B + r P with a_A = -r a_B: a_B = (T_B - r T_A) / (I_B + r^2 I_A).
TEST_CASE("torques on a gear balance by its ratio, and their rest accelerates both inertias") {
    for (const float torque_b : {12.0f, 20.0f}) {  // 12 is 2 * 6
        Wheels wheels(weightless(), BodyType::static_body, 2.0f);
        for (int step = 0; step < 60; ++step) {
            wheels.world.apply_torque(wheels.a, 6.0f);
            wheels.world.apply_torque(wheels.b, torque_b);
            wheels.world.step();
        }
        const double turns = (double{torque_b} - 12.0) / (32.0 + 4.0 * 2.0);
        CHECK(std::abs(wheels.speed(wheels.b) - turns) < kRounding);
        CHECK(std::abs(wheels.speed(wheels.a) + 2.0 * turns) < kRounding);
        const JointReaction reaction = wheels.world.reaction(wheels.gear);
        CHECK(near(reaction.torque, 32.0 * turns - double{torque_b}, absolute(kRounding * 20.0)));
        CHECK(reaction.force == Vec2{});
    }
}

// The rack of m kg hangs on a pinion of radius R = 1 and I: it falls by g m / (m + I / R^2), and the gear carries the
// rest.
TEST_CASE("a rack falls with the acceleration that the inertia of its pinion allows") {
    World world;
    const BodyId wall = world.create_body({.type = BodyType::static_body});
    const BodyId pinion = add_dynamic(world, {}, make_circle(1.0f), {.density = 4.0f / static_cast<float>(kPi)});
    const BodyId rack = add_dynamic(world, {1.5, 0.0}, make_box({1.0f, 3.0f}));
    const JointId hinge = world.create_joint(RevoluteJointDef{.body_a = wall, .body_b = pinion});
    const JointId rail = world.create_joint(
        PrismaticJointDef{.body_a = wall, .body_b = rack, .anchor_a = {1.5f, 0.0f}, .axis_a = {0.0f, 2.0f}});
    for (const bool pinion_first : {true, false}) {
        CAPTURE(pinion_first);
        // At its right end a pinion that turns by q carries the rack up by R q.
        const JointId gear = world.create_joint(GearJointDef{
            .joint_a = pinion_first ? hinge : rail, .joint_b = pinion_first ? rail : hinge, .ratio = -1.0f});
        world.set_velocity(pinion, {}, 0.0f);
        world.set_velocity(rack, {}, 0.0f);
        run(world, 60);
        const double falls = kGravity * 3.0 / (3.0 + 2.0);
        CHECK(std::abs(world.state(rack).velocity.y + falls) < kRounding * kGravity);
        CHECK(std::abs(world.state(pinion).angular_velocity + falls) < kRounding * kGravity);
        // On B: 3 (10 - falls) on the rack, -2 falls on the pinion.
        const JointReaction reaction = world.reaction(gear);
        CHECK(near(reaction.force.y, pinion_first ? 12.0 : 0.0, absolute(kRounding * 12.0)));
        CHECK(near(reaction.torque, pinion_first ? 0.0 : -12.0, absolute(kRounding * 12.0)));
        world.destroy_joint(gear);
    }
}

// P on A, r P on B, and -(1 + r) P on the frame that carries both hinges. The hinges are exact: centrifugal forces
// do not open them, as the frame's centre and the wheels' are in a line and at rest at first.
TEST_CASE("a gear acts on the frame that carries its wheels: angular momentum is conserved") {
    for (const float ratio : {2.0f, -1.5f}) {
        CAPTURE(ratio);
        Wheels wheels(weightless(), BodyType::dynamic_body, ratio);
        wheels.world.set_velocity(wheels.a, {}, 6.0f);
        const double before = angular_momentum(wheels.world);
        run(wheels.world, 60);
        CHECK(near(angular_momentum(wheels.world), before, relative(1e-4)));
        CHECK(std::abs(wheels.speed(wheels.frame)) > 0.1);
        const double turn_a = wheels.speed(wheels.a) - wheels.speed(wheels.frame);
        const double turn_b = wheels.speed(wheels.b) - wheels.speed(wheels.frame);
        CHECK(std::abs(turn_a + double{ratio} * turn_b) < 1e-4);
    }
}

// The arm is B of the first joint and A of the second: P (1 - r) on the arm, r P on the wheel, and (1 - r) w_arm + r
// w_wheel = 0. The one response of both rows solves it at once.
TEST_CASE("a wheel that is geared with ratio 3 to the arm that carries it rotates at 2/3 of its speed") {
    World world = weightless();
    const SurfaceMaterial surface{.density = 4.0f / static_cast<float>(kPi)};
    const BodyId wall = world.create_body({.type = BodyType::static_body});
    const BodyId arm = add_dynamic(world, {}, make_circle(1.0f), surface);
    const BodyId wheel = add_dynamic(world, {}, make_circle(2.0f), surface);
    const JointId pivot = world.create_joint(RevoluteJointDef{.body_a = wall, .body_b = arm});
    const JointId axle = world.create_joint(RevoluteJointDef{.body_a = arm, .body_b = wheel});
    world.create_joint(GearJointDef{.joint_a = pivot, .joint_b = axle, .ratio = 3.0f});
    world.set_velocity(arm, {}, 5.0f);
    world.step();
    const double arm_speed = 5.0 * 9.0 * 2.0 / (9.0 * 2.0 + 4.0 * 32.0);
    CHECK(near(world.state(arm).angular_velocity, arm_speed, kFloat));
    CHECK(near(world.state(wheel).angular_velocity, arm_speed * 2.0 / 3.0, kFloat));
}

TEST_CASE("a gear between two hinges of the same motion applies no impulse") {
    World world = weightless();
    const BodyId wall = world.create_body({.type = BodyType::static_body});
    const BodyId wheel = add_dynamic(world, {}, make_circle(1.0f));
    const JointId one = world.create_joint(RevoluteJointDef{.body_a = wall, .body_b = wheel});
    const JointId two = world.create_joint(RevoluteJointDef{.body_a = wall, .body_b = wheel, .reference_angle = 1.0f});
    world.create_joint(GearJointDef{.joint_a = one, .joint_b = two, .ratio = -1.0f});
    world.set_velocity(wheel, {}, 3.0f);
    run(world, 60);
    CHECK(near(world.state(wheel).angular_velocity, 3.0, kFloat));
}

// A weight on the rim of A drives both: it swings, and would gain energy from errors of the gear.
TEST_CASE("geared wheels that swing by a weight gain at most 1 % of energy in a minute") {
    Wheels wheels(World(WorldDef{.sleeping = false}), BodyType::static_body, 2.0f);
    wheels.world.set_mass(wheels.a, BodyMass{4.0f, {0.8f, 0.0f}, 2.0f});
    const auto energy = [&] {
        double sum = 0.0;
        for (const BodyId id : {wheels.a, wheels.b}) {
            const BodyState state = wheels.world.state(id);
            const BodyMass mass = wheels.world.mass(id);
            const double height = transform_point(state.pose, mass.center).y, w = wheels.speed(id);
            sum += double{mass.mass} * (kGravity * height + 0.5 * length_sq(DVec2(state.velocity))) +
                   0.5 * double{mass.inertia} * w * w;
        }
        return sum + 4.0 * kGravity * 0.8;  // above the lowest position
    };
    const double start = energy();
    double gain = 0.0;
    for (int step = 0; step < 3600; ++step) {
        wheels.world.step();
        gain = std::max(gain, energy() - start);
    }
    CHECK(near(start, 32.0, kFloat));
    CHECK(gain < 0.01 * start);
}
