// Gear joints: ratios, torques, rack and pinion; destruction and sleep of their joints and bodies.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kGravity = 10.0;
constexpr double kRounding = 240 * 20 * 0x1p-24;  // of velocities, a second of sub-steps with 20 roundings in each

// Two wheels of radii 1 and 2 m, hinged to a frame, and a gear on the hinges: I = 2 and 32 kg m^2 for a density of 4 /
// pi.
struct Wheels {
    World world;
    BodyId frame, a, b;
    JointId hinge_a, hinge_b, gear;

    Wheels(World empty, BodyType frame_type, float ratio) : world(std::move(empty)) {
        const SurfaceMaterial surface{.density = 4.0f / static_cast<float>(kPi)};
        frame = add_body(world, frame_type, {}, make_box({4.0f, 0.5f}));
        a = add_dynamic(world, {-1.5, 0.0}, make_circle(1.0f), surface);
        b = add_dynamic(world, {1.5, 0.0}, make_circle(2.0f), surface);
        hinge_a = world.create_joint(RevoluteJointDef{.body_a = frame, .body_b = a, .anchor_a = {-1.5f, 0.0f}});
        hinge_b = world.create_joint(RevoluteJointDef{.body_a = frame, .body_b = b, .anchor_a = {1.5f, 0.0f}});
        gear = world.create_joint(GearJointDef{.joint_a = hinge_a, .joint_b = hinge_b, .ratio = ratio});
    }

    double speed(BodyId body) const { return double{world.state(body).angular_velocity}; }
    double turned(BodyId body) const { return angle(world.state(body).pose.rotation); }
};

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

TEST_CASE("a gear is destroyed with either of its joints, and with one of their bodies") {
    for (int what = 0; what < 4; ++what) {
        CAPTURE(what);
        Wheels wheels(weightless(), BodyType::static_body, 1.0f);
        if (what == 0) wheels.world.destroy_joint(wheels.hinge_a);
        if (what == 1) wheels.world.destroy_joint(wheels.hinge_b);
        if (what == 2) wheels.world.destroy_body(wheels.b);
        if (what == 3) wheels.world.destroy_body(wheels.frame);
        CHECK(!wheels.world.is_valid(wheels.gear));
        wheels.world.audit();
        run(wheels.world, 2);
        CHECK(wheels.world.events().broken_joints.empty());
    }
}

TEST_CASE("a gear breaks by the torque on its second wheel, and has no event if one of its hinges breaks") {
    for (const float strength : {5.9f, 6.1f}) {
        Wheels wheels(weightless(), BodyType::static_body, 1.0f);
        GearJointDef def = std::get<GearJointDef>(wheels.world.joint(wheels.gear));
        CHECK(def.body_b == wheels.b);
        def.break_torque = strength;
        wheels.world.set_joint(wheels.gear, def);
        wheels.world.set_type(wheels.b, BodyType::static_body);
        wheels.world.apply_torque(wheels.a, 6.0f);
        wheels.world.step();
        CHECK(wheels.world.is_valid(wheels.gear) == (strength > 6.0f));
        CHECK(wheels.world.is_valid(wheels.hinge_a));
    }
    Wheels wheels(weightless(), BodyType::static_body, 1.0f);
    RevoluteJointDef hinge = std::get<RevoluteJointDef>(wheels.world.joint(wheels.hinge_b));
    GearJointDef gear = std::get<GearJointDef>(wheels.world.joint(wheels.gear));
    hinge.break_force = gear.break_torque = 1.0f;  // both at once
    wheels.world.set_joint(wheels.hinge_b, hinge);
    wheels.world.set_joint(wheels.gear, gear);
    wheels.world.apply_force(wheels.b, {0.0f, 100.0f}, {3.0, 0.0});
    wheels.world.step();
    CHECK(!wheels.world.is_valid(wheels.gear));
    CHECK(!wheels.world.is_valid(wheels.hinge_b));
    CHECK(wheels.world.events().broken_joints.size() == 2);
    wheels.world.audit();
}

TEST_CASE("geared bodies fall asleep and wake as one, for both orders of the bodies of their joints") {
    for (const bool reversed : {false, true}) {
        CAPTURE(reversed);
        World world;
        const BodyId wall = world.create_body({.type = BodyType::static_body});
        const BodyId a = add_dynamic(world, {-3.0, 0.0}, make_circle(1.0f));
        const BodyId b = add_dynamic(world, {3.0, 0.0}, make_circle(1.0f));
        const auto hinge = [&](BodyId wheel, Vec2 at) {
            return world.create_joint(reversed ? RevoluteJointDef{.body_a = wheel, .body_b = wall, .anchor_b = at}
                                               : RevoluteJointDef{.body_a = wall, .body_b = wheel, .anchor_a = at});
        };
        const JointId hinge_a = hinge(a, {-3.0f, 0.0f}), hinge_b = hinge(b, {3.0f, 0.0f});
        const JointId gear = world.create_joint(GearJointDef{.joint_a = hinge_a, .joint_b = hinge_b});
        CHECK(world.islands() == std::vector<int>{-1, 0, 0});
        run(world, 60);
        REQUIRE(!world.is_awake(a));
        REQUIRE(!world.is_awake(b));
        world.audit();
        world.apply_angular_impulse(a, 1.0f);
        CHECK(world.is_awake(b));
        run(world, 10);
        CHECK(near(world.state(b).angular_velocity, -world.state(a).angular_velocity, kFloat));
        CHECK(world.state(b).angular_velocity < -0.1f);
        // Put to sleep separately, they become one island again by a new gear.
        world.destroy_joint(gear);
        world.set_velocity(a, {}, 0.0f);
        world.set_velocity(b, {}, 0.0f);
        run(world, 60);
        REQUIRE(!world.is_awake(a));
        REQUIRE(!world.is_awake(b));
        world.create_joint(GearJointDef{.joint_a = hinge_a, .joint_b = hinge_b});
        CHECK(!world.is_awake(a));
        world.audit();
        world.set_awake(b, true);
        CHECK(world.is_awake(a));
        world.audit();
    }
}

TEST_CASE("a gear does not act while one of its bodies is disabled") {
    Wheels wheels(weightless(), BodyType::dynamic_body, 1.0f);
    for (const BodyId body : {wheels.frame, wheels.a}) {
        wheels.world.set_enabled(body, false);
        wheels.world.audit();
        wheels.world.set_velocity(wheels.b, {}, 3.0f);
        run(wheels.world, 5);
        CHECK(near(wheels.speed(wheels.b), 3.0, kFloat));
        wheels.world.set_enabled(body, true);
        wheels.world.audit();
    }
    run(wheels.world, 60);
    const double frame = wheels.speed(wheels.frame);
    CHECK(near(wheels.speed(wheels.a) - frame, frame - wheels.speed(wheels.b), kFloat));
}

TEST_CASE("a change of ratio or motor keeps the present positions") {
    Wheels wheels(weightless(), BodyType::static_body, 1.0f);
    wheels.world.set_velocity(wheels.a, {}, 4.0f);
    wheels.world.set_velocity(wheels.b, {}, -4.0f);
    run(wheels.world, 20);
    RevoluteJointDef hinge = std::get<RevoluteJointDef>(wheels.world.joint(wheels.hinge_a));
    hinge.motor = AngularMotor{4.0f, 1000.0f};
    wheels.world.set_joint(wheels.hinge_a, hinge);
    run(wheels.world, 2);
    CHECK(std::abs(wheels.world.joint_position(wheels.gear)) < 1e-4f);
    GearJointDef gear = std::get<GearJointDef>(wheels.world.joint(wheels.gear));
    gear.ratio = 4.0f;
    wheels.world.set_joint(wheels.gear, gear);
    wheels.world.set_velocity(wheels.b, {}, -1.0f);
    run(wheels.world, 2);
    CHECK(std::abs(wheels.world.joint_position(wheels.gear)) < 1e-4f);
    run(wheels.world, 60);
    CHECK(near(wheels.speed(wheels.a), 4.0, kFloat));
    CHECK(near(wheels.speed(wheels.b), -1.0, kFloat));
}

TEST_CASE("a gear continues when the anchor of its slider is changed") {
    World world = weightless();
    const BodyId wall = world.create_body({.type = BodyType::static_body});
    const BodyId left = add_dynamic(world, {-2.0, 0.0}, make_box({1.0f, 1.0f}));
    const BodyId right = add_dynamic(world, {2.0, 0.0}, make_box({1.0f, 1.0f}));
    PrismaticJointDef rail{.body_a = wall, .body_b = left, .anchor_a = {-2.0f, 0.0f}, .axis_a = {0.0f, 1.0f}};
    const JointId rail_a = world.create_joint(rail);
    const JointId rail_b = world.create_joint(
        PrismaticJointDef{.body_a = wall, .body_b = right, .anchor_a = {2.0f, 0.0f}, .axis_a = {0.0f, 1.0f}});
    world.create_joint(GearJointDef{.joint_a = rail_a, .joint_b = rail_b});
    world.set_velocity(left, {0.0f, 0.5f}, 0.0f);
    world.set_velocity(right, {0.0f, -0.5f}, 0.0f);
    run(world, 30);
    rail.anchor_a.y = -3.0f;  // the displacement is 3 m more, the pose the same
    world.set_joint(rail_a, rail);
    run(world, 30);
    CHECK(near(world.state(left).pose.position.y, 0.5, kFloat));
    CHECK(near(world.state(right).pose.position.y, -0.5, kFloat));
}

TEST_CASE("gears and pulleys continue with the same bits from a snapshot") {
    Wheels wheels(World(), BodyType::dynamic_body, 1.5f);
    wheels.world.set_velocity(wheels.a, {}, 6.0f);
    wheels.world.create_joint(PulleyJointDef{.body_a = wheels.frame,
                                             .body_b = wheels.b,
                                             .anchor_b = {1.0f, 0.0f},
                                             .ground_anchor_a = {0.0, 5.0},
                                             .ground_anchor_b = {2.0, 6.0},
                                             .length = 9.0f});
    for (int step = 0; step < 60; ++step) {
        World loaded = World::load(wheels.world.save());
        loaded.step();
        wheels.world.step();
        REQUIRE(loaded.save() == wheels.world.save());
    }
}

TEST_CASE("invalid gears throw, and leave the world as it was") {
    Wheels wheels(weightless(), BodyType::static_body, 1.0f);
    World& world = wheels.world;
    const JointId weld = world.create_joint(WeldJointDef{.body_a = wheels.frame, .body_b = wheels.a});
    const std::vector<std::byte> before = world.save();
    const auto refused = [&](const GearJointDef& def, const char* message) {
        CHECK_THROWS_WITH_AS(world.create_joint(def), doctest::Contains(message), std::invalid_argument);
    };
    refused({.joint_a = wheels.hinge_a, .joint_b = wheels.hinge_a}, "twice");
    refused({.joint_a = wheels.hinge_a, .joint_b = weld}, "revolute or prismatic");
    refused({.joint_a = wheels.gear, .joint_b = wheels.hinge_a}, "revolute or prismatic");
    refused({.joint_a = wheels.hinge_a}, "stale");
    refused({.joint_a = wheels.hinge_a, .joint_b = wheels.hinge_b, .ratio = 0.0f}, "joint ratio");
    CHECK_THROWS_AS(world.set_joint(wheels.gear, GearJointDef{.joint_a = wheels.hinge_b, .joint_b = wheels.hinge_a}),
                    std::invalid_argument);
    CHECK(world.save() == before);
}
