// The present position and speed of joints, and the setters of one of their members.
#include <doctest/doctest.h>

#include <cmath>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

struct Pair {
    World world{WorldDef{.gravity = {}}};
    BodyId a = world.create_body({.type = BodyType::static_body});
    BodyId b{};

    explicit Pair(DVec2 position, double radians = 0.0) {
        b = add_dynamic(world, position, make_box({1.0f, 1.0f}), {}, radians);
    }
    JointMotion motion(const JointDef& def) { return world.joint_motion(world.create_joint(def)); }
};

}  // namespace

TEST_CASE("the motion of a hinge is its angle and the difference of the angular velocities, before any step") {
    Pair p({0.0, 0.0}, 0.5);
    p.world.set_velocity(p.b, {}, 3.0f);
    const JointMotion motion = p.motion(RevoluteJointDef{.body_a = p.a, .body_b = p.b, .reference_angle = 0.25f});
    CHECK(near(motion.position, 0.25, absolute(1e-7)));  // a rotation in float
    CHECK(motion.speed == 3.0);
}

TEST_CASE("a hinge with limits counts whole turns, one without does not") {
    for (const bool counts : {true, false}) {
        Pair p({0.0, 0.0});
        RevoluteJointDef def{.body_a = p.a, .body_b = p.b, .motor = AngularMotor{6.0f, 1e6f}};
        if (counts) def.limits = JointLimits{-100.0f, 100.0f};
        const JointId joint = p.world.create_joint(def);
        for (int i = 0; i < 120; ++i) p.world.step();
        const double turned = 12.0 - (counts ? 0.0 : 4.0 * kPi);  // 2 s at 6 rad/s
        CHECK(near(p.world.joint_motion(joint).position, turned, absolute(1e-3)));
        CHECK(near(p.world.joint_motion(joint).speed, 6.0, relative(1e-4)));
    }
}

TEST_CASE("the motion of a slider is the displacement along its axis, which turns with A") {
    World world({.gravity = {}});
    const BodyId a = add_dynamic(world, {1.0, 1.0}, make_circle(0.5f), {}, kPi / 2);
    const BodyId b = add_dynamic(world, {1.0, 4.0}, make_circle(0.5f));
    world.set_velocity(a, {0.0f, 1.0f}, 2.0f);
    world.set_velocity(b, {5.0f, 4.0f}, 0.0f);
    // The axis (1, 0) of A points up. b is 3 m along it; A's point there moves by 2 rad/s x 3 m to the left and up
    // by 1.
    const JointMotion motion = world.joint_motion(world.create_joint(PrismaticJointDef{
        .body_a = a, .body_b = b, .axis_a = {2.0f, 0.0f}, .reference_angle = static_cast<float>(-kPi / 2)}));
    CHECK(near(motion.position, 3.0, absolute(1e-6)));
    CHECK(near(motion.speed, 3.0, absolute(1e-5)));
}

TEST_CASE("the motion of rods, mice and pulleys is a length and its change") {
    Pair p({3.0, 4.0});
    p.world.set_velocity(p.b, {5.0f, 0.0f}, 0.0f);
    const JointMotion rod = p.motion(DistanceJointDef{.body_a = p.a, .body_b = p.b, .length = 5.0f});
    CHECK(rod.position == 5.0);
    CHECK(near(rod.speed, 3.0, kDouble));  // 3/5 of the velocity
    const JointMotion mouse = p.motion(MouseJointDef{.body_a = p.a, .body_b = p.b, .max_force = 1.0f});
    CHECK(mouse.position == rod.position);
    CHECK(mouse.speed == rod.speed);
    const JointMotion rope = p.motion(
        PulleyJointDef{.body_a = p.b, .body_b = p.a, .ground_anchor_a = {3.0, 9.0}, .ground_anchor_b = {1.0, 9.0}});
    CHECK(rope.position == 5.0);
    CHECK(rope.speed == 0.0);  // across the rope
    CHECK(p.motion(FilterJointDef{p.a, p.b}).position == 0.0);
}

TEST_CASE("the speed of a joint is the change of its position from step to step") {
    World world;
    const BodyId ground = world.create_body({.type = BodyType::static_body});
    const BodyId arm = add_dynamic(world, {1.0, 0.0}, make_box({2.0f, 0.2f}));
    const JointId hinge =
        world.create_joint(RevoluteJointDef{.body_a = ground, .body_b = arm, .anchor_b = {-1.0f, 0.0f}});
    for (int i = 0; i < 30; ++i) {
        const double before = world.joint_motion(hinge).position;
        world.step();
        const JointMotion now = world.joint_motion(hinge);
        // Four sub-steps of h = 1/240 s move by the velocities after each of them: w - 3 h a to w, whose mean is
        // w - 1.5 h a. a = -g cos(angle) / k^2, with k^2 = (2^2 + 0.2^2) m^2 / 12 + 1 m^2, changes by less than
        // g |w| / k^2 / 60 s in the step, and |w| is below sqrt(2 g / k^2) = 3.9 rad/s: 1.5 h times that is 3e-3 rad/s.
        const double acceleration = -10.0 * std::cos(now.position) / (4.04 / 12.0 + 1.0);
        CHECK(near(60.0 * (now.position - before), now.speed - 1.5 / 240.0 * acceleration, absolute(3.1e-3)));
    }
    CHECK(std::abs(world.joint_motion(hinge).speed) > 1.0);
}

TEST_CASE("a setter of one member gives the bits of set_joint()") {
    const auto run = [](bool by_setters) {
        World world;
        add_floor(world);
        const BodyId ground = world.create_body({.type = BodyType::static_body});
        const BodyId cart = add_dynamic(world, {0.0, 1.0}, make_box({1.0f, 0.5f}));
        PrismaticJointDef def{.body_a = ground, .body_b = cart, .anchor_a = {0.0f, 1.0f}};
        const JointId joint = world.create_joint(def);
        for (int i = 0; i < 90; ++i) {
            const float speed = i % 20 < 10 ? 3.0f : -2.0f;
            def.motor = {speed, 20.0f};
            if (i >= 30) def.limits = JointLimits{-0.5f, 0.25f};
            if (i >= 60) def.spring = JointSpring{2.0f, 0.5f};
            if (by_setters) {
                world.set_motor(joint, 0.0f, 20.0f);
                world.set_motor_speed(joint, speed);
                world.set_limits(joint, def.limits);
                world.set_spring(joint, def.spring);
            } else {
                world.set_joint(joint, def);
            }
            world.step();
        }
        return world.state_hash();
    };
    CHECK(run(true) == run(false));
}

TEST_CASE("set_target() moves the point to which a mouse joint pulls") {
    Pair p({0.0, 0.0});
    const JointId mouse =
        p.world.create_joint(MouseJointDef{.body_a = p.a, .body_b = p.b, .spring = {5.0f, 1.0f}, .max_force = 1000.0f});
    p.world.set_target(mouse, {2.0, 1.0});
    for (int i = 0; i < 120; ++i) p.world.step();
    const DVec2 position = p.world.state(p.b).pose.position;
    CHECK(near(position.x, 2.0, absolute(1e-3)));
    CHECK(near(position.y, 1.0, absolute(1e-3)));
}

TEST_CASE("a setter wakes the bodies, and refuses what the joint does not have") {
    Pair p({0.0, 0.0});
    const JointId hinge = p.world.create_joint(RevoluteJointDef{.body_a = p.a, .body_b = p.b});
    const JointId weld = p.world.create_joint(WeldJointDef{.body_a = p.a, .body_b = p.b});
    CHECK_THROWS_WITH_AS(p.world.set_motor_speed(hinge, 1.0f), "joint 0 has no motor", std::invalid_argument);
    CHECK_THROWS_AS(p.world.set_motor(weld, 1.0f, 1.0f), std::invalid_argument);
    CHECK_THROWS_AS(p.world.set_limits(weld, JointLimits{}), std::invalid_argument);
    CHECK_THROWS_AS(p.world.set_spring(weld, JointSpring{}), std::invalid_argument);
    CHECK_THROWS_AS(p.world.set_target(hinge, {}), std::invalid_argument);
    CHECK_THROWS_AS(p.world.set_motor(hinge, 1.0f, -1.0f), std::invalid_argument);
    CHECK_THROWS_AS(p.world.set_limits(hinge, JointLimits{1.0f, 0.0f}), std::invalid_argument);
    p.world.set_awake(p.b, false);
    p.world.set_motor(hinge, 1.0f, 1.0f);
    CHECK(p.world.is_awake(p.b));
    p.world.destroy_joint(hinge);
    CHECK_THROWS_AS(p.world.joint_motion(hinge), std::invalid_argument);
    CHECK_THROWS_AS(p.world.set_motor_speed(hinge, 1.0f), std::invalid_argument);
}
