// Gear joints with the lives of their joints and bodies: destruction, sleep, changes, snapshots, invalid definitions.
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "support/geared_wheels.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::test;

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
    refused({.joint_a = wheels.hinge_a}, "joint id is the default one");
    refused({.joint_a = wheels.hinge_a, .joint_b = wheels.hinge_b, .ratio = 0.0f}, "joint ratio");
    CHECK_THROWS_AS(world.set_joint(wheels.gear, GearJointDef{.joint_a = wheels.hinge_b, .joint_b = wheels.hinge_a}),
                    std::invalid_argument);
    CHECK(world.save() == before);
}
