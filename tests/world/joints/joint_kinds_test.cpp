// Each kind of joint, its limits and motor, against the mechanics of one body.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/joint_rig.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kGravity = 10.0;
constexpr double kH = 1.0 / 240.0;
constexpr double kJointOmega = 2.0 * kPi * 60.0;  // joint softness, rad/s
// How far a joint yields to a weight that hangs on it, F / (m w^2) with F = m g: 0.07 mm.
constexpr double kSag = kGravity / (kJointOmega * kJointOmega);

}  // namespace

TEST_CASE("a hinge stays inside its limits, and its reaction there is the moment of the weight") {
    Rig rig(true, {0.5, 0.0});
    const JointId hinge = rig.world.create_joint(RevoluteJointDef{
        .body_a = rig.pivot, .body_b = rig.box, .anchor_b = {-0.5f, 0.0f}, .limits = JointLimits{-0.4f, 0.3f}});
    double lowest = 0.0;
    for (int step = 0; step < 240; ++step) {
        rig.world.step();
        lowest = std::min(lowest, rig.angle());
    }
    // It falls on the limit at w = sqrt(2 m g 0.5 sin 0.4 / I) = 2.4 rad/s, which is stopped within a sub-step, and
    // rests there: the limit yields by torque / (I w^2), with I about the centre of mass.
    const BodyMass mass = rig.world.mass(rig.box);
    const double moment = double{mass.mass} * kGravity * 0.5 * std::cos(0.4);
    const double excess = moment / (double{mass.inertia} * kJointOmega * kJointOmega);
    CHECK(lowest > -0.4 - 2.4 * kH - excess);
    CHECK(near(rig.angle(), -0.4 - excess, absolute(1e-6)));
    CHECK(near(rig.world.reaction(hinge).torque, moment, relative(excess)));  // the cosine changes with the excess
    rig.world.set_velocity(rig.box, {}, 6.0f);
    double highest = -1.0;
    for (int step = 0; step < 60; ++step) {
        rig.world.step();
        highest = std::max(highest, rig.angle());
    }
    CHECK(highest > 0.29);
    CHECK(highest < 0.3 + 6.0 * kH);
}

TEST_CASE("limits of more than a turn count whole turns") {
    Rig rig(false);
    const JointId hinge = rig.world.create_joint(
        RevoluteJointDef{.body_a = rig.pivot, .body_b = rig.box, .limits = JointLimits{-1.0f, 15.0f}});
    rig.world.set_velocity(rig.box, {}, 10.0f);
    run(rig.world, 300);
    // 15 rad = 2.39 turns: wrapped into (-pi, pi] that is 2.434.
    CHECK(near(rig.angle(), 15.0 - 4.0 * kPi, kFloat));
    CHECK(near(rig.world.joint_position(hinge), 15.0, kFloat));
}

TEST_CASE("a motor rotates a hinge at its speed, with no more than its torque") {
    Rig rig(false);
    const BodyMass mass = rig.world.mass(rig.box);
    rig.world.create_joint(RevoluteJointDef{.body_a = rig.pivot, .body_b = rig.box, .motor = AngularMotor{3.0f, 2.0f}});
    run(rig.world, 30);
    // w = T t / I until the speed is reached: 2 * 0.5 / (2 * 5 / 12) = 1.2 rad/s after half a second.
    CHECK(near(rig.world.state(rig.box).angular_velocity, 2.0 * 0.5 / double{mass.inertia}, float_sum(120)));
    run(rig.world, 60);
    CHECK(near(rig.world.state(rig.box).angular_velocity, 3.0, kFloat));
}

TEST_CASE("a rope is slack until it is taut, and then carries the weight") {
    Rig rig(true, {0.0, -1.0});
    const JointId rope = rig.world.create_joint(
        DistanceJointDef{.body_a = rig.pivot, .body_b = rig.box, .limits = JointLimits{0.0f, 2.0f}});
    run(rig.world, 12);
    // Free fall: 10 * 0.2^2 / 2, and half a sub-step more.
    CHECK(near(-rig.position().y - 1.0, 0.2 + 10.0 * 0.2 * kH / 2.0, kFloat));
    CHECK(rig.world.reaction(rope).force == Vec2{});
    run(rig.world, 300);
    CHECK(near(-rig.position().y, 2.0 + kSag, absolute(1e-6)));
    CHECK(near(rig.world.reaction(rope).force.y, 20.0, kFloat));
}

TEST_CASE("a slider stays on its axis, which rotates with A, and does not rotate against A") {
    World world = weightless();
    const BodyId rail = add_static(world, {}, make_box({0.1f, 0.1f}), {}, 0.5);
    const BodyId box = add_dynamic(world, {}, make_box({1.0f, 1.0f}), {}, 0.5);
    world.create_joint(PrismaticJointDef{.body_a = rail, .body_b = box, .axis_a = {2.0f, 0.0f}});
    world.set_velocity(box, {3.0f, 1.0f}, 4.0f);
    run(world, 60);
    const DVec2 axis{std::cos(0.5), std::sin(0.5)};
    const BodyState state = world.state(box);
    CHECK(std::abs(cross(axis, state.pose.position)) < 1e-3);
    CHECK(near(angle(state.pose.rotation), 0.5, kFloat));
    // What is left is the part of the velocity along the axis.
    CHECK(near(length(state.pose.position), 3.0 * axis.x + 1.0 * axis.y, kFloat));
}

TEST_CASE("a lift's motor raises its load at its speed up to the limit, or stalls") {
    for (const float force : {25.0f, 19.0f}) {  // the box weighs 20 N
        Rig rig(true);
        const JointId lift = rig.world.create_joint(PrismaticJointDef{.body_a = rig.pivot,
                                                                      .body_b = rig.box,
                                                                      .axis_a = {0.0f, 1.0f},
                                                                      .limits = JointLimits{-1.0f, 2.0f},
                                                                      .motor = LinearMotor{1.0f, force}});
        run(rig.world, 60);
        // A limit carries what the motor leaves of the weight, and yields by that over m w^2.
        const double excess = 1.01 * std::abs(double{force} - 20.0) / (2.0 * kJointOmega * kJointOmega);
        if (force > 20.0f) {
            // Accelerates by (25 - 20) / 2 = 2.5 m/s^2 for 0.4 s, then moves at 1 m/s: 0.2 + 0.6 m in the first second,
            // and half a sub-step's motion more, as it moves with the velocity at the end of each.
            CHECK(near(rig.position().y, 0.8 + 0.5 * kH, float_sum(240)));
            CHECK(near(rig.world.state(rig.box).velocity.y, 1.0, kFloat));
            CHECK(near(rig.world.reaction(lift).force.y, 20.0, kFloat));
            run(rig.world, 120);
            CHECK(near(rig.position().y, 2.0, absolute(excess)));
        } else {
            run(rig.world, 240);
            CHECK(near(rig.position().y, -1.0, absolute(excess)));
        }
    }
}

// Its weight of 20 N on an arm of 0.3 m is a torque of 6 N m. It sags by F / (m w^2) = 0.1 mm.
TEST_CASE("the rail of a slider with its weight beside the rail keeps it upright") {
    Rig rig(true, {0.3, 0.0});
    const JointId lift = rig.world.create_joint(PrismaticJointDef{.body_a = rig.pivot,
                                                                  .body_b = rig.box,
                                                                  .anchor_b = {-0.3f, 0.0f},
                                                                  .axis_a = {0.0f, 1.0f},
                                                                  .limits = JointLimits{-1.0f, 2.0f}});
    run(rig.world, 240);
    CHECK(near(rig.position().y, -1.0 - kSag, absolute(1e-6)));
    CHECK(std::abs(rig.angle()) < 1e-3);
    const JointReaction reaction = rig.world.reaction(lift);
    CHECK(near(reaction.force.y, 20.0, kFloat));
    CHECK(std::abs(reaction.force.x) < 0.02f);
    CHECK(near(reaction.torque, 6.0, kFloat));
}

// If the motor pushed against the limit, the limit would yield by F / (m w^2) = 500 / (2 w^2) = 1.8 mm, or T / (I
// w^2).
TEST_CASE("a strong motor stops at the limit, and keeps its load there") {
    Rig lift(true);
    const JointId joint = lift.world.create_joint(PrismaticJointDef{.body_a = lift.pivot,
                                                                    .body_b = lift.box,
                                                                    .axis_a = {0.0f, 1.0f},
                                                                    .limits = JointLimits{-1.0f, 1.0f},
                                                                    .motor = LinearMotor{2.0f, 500.0f}});
    run(lift.world, 120);
    CHECK(std::abs(lift.position().y - 1.0) < 1e-5);
    CHECK(std::abs(lift.world.state(lift.box).velocity.y) < 1e-5f);
    CHECK(near(lift.world.reaction(joint).force.y, 20.0, kFloat));
    Rig hinge(false);
    hinge.world.create_joint(RevoluteJointDef{.body_a = hinge.pivot,
                                              .body_b = hinge.box,
                                              .limits = JointLimits{-0.5f, 0.7f},
                                              .motor = AngularMotor{-3.0f, 1000.0f}});
    run(hinge.world, 120);
    CHECK(std::abs(hinge.angle() + 0.5) < 1e-5);
}

TEST_CASE("a slider tens of kilometres off its rail is still solved") {
    World world = weightless();
    const BodyId rail = add_body(world, BodyType::kinematic_body, {}, make_box({0.1f, 0.1f}));
    world.set_velocity(rail, {-5.7f, 3.4f}, 7.5f);
    const BodyId box = add_dynamic(world, {}, make_box({4.0f, 3.0f}));
    world.create_joint(PrismaticJointDef{.body_a = box,
                                         .body_b = rail,
                                         .anchor_a = {0.1f, 0.0f},
                                         .axis_a = {1.0f, 2.0f},
                                         .limits = JointLimits{0.5f, 1.0f}});
    world.set_transform(box, {{-29261.7, 27670.6}, make_rotation(1.0)});
    world.set_velocity(box, {322.0f, -237.0f}, -47.0f);
    const double torn = length(world.state(box).pose.position);
    CHECK_NOTHROW(run(world, 300));
    // The box turns with its rail, and approaches it no faster than the speed limit.
    const BodyState state = world.state(box);
    CHECK(near(state.angular_velocity, 7.5, kFloat));
    CHECK(length(state.pose.position - world.state(rail).pose.position) < torn - 1000.0);
    CHECK(length(state.velocity) < 400.1f);
    world.audit();
}

TEST_CASE("the reaction of a welded beam is its weight and moment at the wall") {
    Rig rig(true, {0.5, 0.0});
    const JointId weld =
        rig.world.create_joint(WeldJointDef{.body_a = rig.pivot, .body_b = rig.box, .anchor_b = {-0.5f, 0.0f}});
    run(rig.world, 120);
    CHECK(near(rig.world.reaction(weld).force.y, 20.0, kFloat));
    CHECK(near(rig.world.reaction(weld).torque, 10.0, kFloat));
    CHECK(std::abs(rig.angle()) < 0.001);
    CHECK(length(rig.position() - DVec2{0.5, 0.0}) < 0.001);
}

TEST_CASE("a wheel rides on its suspension and is driven by its motor") {
    Rig rig(true);
    const BodyId wheel = add_dynamic(rig.world, {3.0, 0.0}, make_circle(0.5f));
    rig.world.create_joint(WheelJointDef{.body_a = rig.pivot,
                                         .body_b = wheel,
                                         .anchor_a = {3.0f, 0.0f},
                                         .motor = AngularMotor{-5.0f, 10.0f},
                                         .spring = JointSpring{2.0f, 0.7f}});
    run(rig.world, 240);
    const BodyState state = rig.world.state(wheel);
    CHECK(near(state.pose.position.x, 3.0, kFloat));
    CHECK(near(state.pose.position.y, -kGravity / (16.0 * kPi * kPi), kFloat));
    CHECK(near(state.angular_velocity, -5.0, kFloat));
}

TEST_CASE("a wheel stays on the axis of its suspension, which turns with A") {
    World world = weightless();
    const BodyId frame = add_body(world, BodyType::kinematic_body, {}, make_box({0.1f, 0.1f}));
    const BodyId wheel = add_dynamic(world, {3.0, 0.0}, make_circle(0.5f));
    world.create_joint(WheelJointDef{.body_a = frame,
                                     .body_b = wheel,
                                     .anchor_a = {3.0f, 0.0f},
                                     .axis_a = {0.0f, 1.0f},
                                     .spring = JointSpring{20.0f, 1.0f}});
    world.set_velocity(frame, {}, 4.0f);
    world.set_velocity(wheel, {0.0f, 12.0f}, 0.0f);
    double across = 0.0, along = 0.0;
    for (int step = 0; step < 240; ++step) {
        world.step();
        const DVec2 local = inverse_transform_point(world.state(frame).pose, world.state(wheel).pose.position);
        across = std::max(across, std::abs(local.x - 3.0));
        along = std::max(along, std::abs(local.y));
    }
    // The row across carries the centrifugal force, and yields by v^2 / (r w^2) = 48 / w^2. A sub-step along the
    // tangent leaves the circle by (v h)^2 / (2 r) = 0.42 mm, of which the soft row, of damping ratio 2, takes back the
    // part (w h)^2 / (1 + 4 w h + (w h)^2) = 0.25 in each.
    constexpr double wh = kJointOmega * kH, taken_back = wh * wh / (1.0 + 4.0 * wh + wh * wh);
    CHECK(across < 48.0 / (kJointOmega * kJointOmega) + 12.0 * kH * 12.0 * kH / 6.0 / taken_back);
    CHECK(along < 0.01);
}

// It is carried around at the end of its travel: 0.5 m from the axis' foot, which is the centre of A.
TEST_CASE("the axis of a suspension turns with A within a step") {
    World world = weightless();
    const BodyId frame = add_body(world, BodyType::kinematic_body, {}, make_box({0.1f, 0.1f}));
    const BodyId wheel = add_dynamic(world, {0.0, 0.5}, make_circle(0.1f));
    world.create_joint(
        WheelJointDef{.body_a = frame, .body_b = wheel, .axis_a = {0.0f, 1.0f}, .limits = JointLimits{0.0f, 0.5f}});
    world.set_velocity(frame, {}, 8.0f);
    world.set_velocity(wheel, {-4.0f, 0.0f}, 0.0f);
    run(world, 120);
    const DVec2 local = inverse_transform_point(world.state(frame).pose, world.state(wheel).pose.position);
    CHECK(std::abs(local.x) < 1e-4);  // nothing pulls across the axis
    // v^2 / (r w^2) = 0.23 mm, and four times the (v h)^2 / (2 r) = 0.28 mm of a sub-step along the tangent.
    CHECK(near(local.y, 0.5, absolute(0.0014)));
}

TEST_CASE("a suspension stops at its limits") {
    Rig rig(true);
    rig.world.create_joint(WheelJointDef{.body_a = rig.pivot, .body_b = rig.box, .limits = JointLimits{-0.25f, 0.25f}});
    run(rig.world, 120);
    CHECK(near(rig.position().y, -0.25 - kSag, absolute(1e-6)));
}

TEST_CASE("a motor joint without a spring is friction: v^2 m / (2 F) to a stop") {
    Rig rig(false);
    rig.world.create_joint(
        MotorJointDef{.body_a = rig.pivot, .body_b = rig.box, .max_force = 4.0f, .max_torque = 1.0f});
    rig.world.set_velocity(rig.box, {0.0f, 3.0f}, 2.0f);
    run(rig.world, 50);
    // T t / I of the spin is lost: 1 * (50 / 60) / (10 / 12) = 1 rad/s.
    CHECK(near(rig.world.state(rig.box).angular_velocity, 1.0, float_sum(200)));
    run(rig.world, 70);
    // 9 * 2 / 8 = 2.25 m, less half a sub-step of the speed.
    CHECK(near(rig.position().y, 2.25 - 3.0 * kH / 2.0, float_sum(360)));
    CHECK(rig.world.state(rig.box).angular_velocity == 0.0f);
}

TEST_CASE("a motor joint drives at a velocity, and with a spring to a pose") {
    Rig rig(false, {2.0, 1.0});
    MotorJointDef def{.body_a = rig.pivot,
                      .body_b = rig.box,
                      .velocity = {1.0f, 0.0f},
                      .angular_velocity = -0.5f,
                      .max_force = 50.0f,
                      .max_torque = 50.0f};
    const JointId motor = rig.world.create_joint(def);
    run(rig.world, 60);
    CHECK(near(rig.world.state(rig.box).velocity.x, 1.0, kFloat));
    CHECK(near(rig.world.state(rig.box).angular_velocity, -0.5, kFloat));
    def.velocity = {};
    def.angular_velocity = 0.0f;
    def.reference_angle = 0.5f;
    def.spring = JointSpring{2.0f, 1.0f};
    rig.world.set_joint(motor, def);
    run(rig.world, 240);
    CHECK(length(rig.position()) < 1e-3);
    CHECK(near(rig.angle(), 0.5, kFloat));
}

TEST_CASE("a mouse joint drags a body to its target with at most max_force") {
    Rig rig(true);
    MouseJointDef def{.body_a = rig.pivot, .body_b = rig.box, .anchor_a = {4.0f, 3.0f}, .max_force = 100.0f};
    const JointId mouse = rig.world.create_joint(def);
    for (int step = 0; step < 300; ++step) {
        rig.world.step();
        CHECK(length(rig.world.reaction(mouse).force) <= 100.001f);
    }
    // It hangs below the target by g / w^2.
    const double sag = kGravity / (4.0 * kPi * kPi * 25.0);
    CHECK(length(rig.position() - DVec2{4.0, 3.0 - sag}) < 1e-3);
    def.anchor_a = {-1.0f, 0.0f};
    rig.world.set_joint(mouse, def);
    run(rig.world, 300);
    CHECK(length(rig.position() - DVec2{-1.0, -sag}) < 1e-3);
}

TEST_CASE("a filter joint keeps two bodies from touching") {
    World world;
    add_floor(world);
    const BodyId a = add_dynamic(world, {0.0, 0.5}, make_box({1.0f, 1.0f}));
    const BodyId b = add_dynamic(world, {0.0, 3.0}, make_box({1.0f, 1.0f}));
    world.create_joint(FilterJointDef{a, b});
    run(world, 120);
    CHECK(near(world.state(b).pose.position.y, 0.5, absolute(kRestingDepth)));
}

TEST_CASE("a joint breaks above its force, and not below") {
    for (const float strength : {19.9f, 20.1f}) {  // the box weighs 20 N
        Rig rig(true);
        const JointId hinge =
            rig.world.create_joint(RevoluteJointDef{.body_a = rig.pivot, .body_b = rig.box, .break_force = strength});
        int broken_at = -1;
        for (int step = 0; step < 120; ++step) {
            rig.world.step();
            if (!rig.world.events().broken_joints.empty()) {
                CHECK(rig.world.events().broken_joints[0] == hinge);
                CHECK(broken_at == -1);
                broken_at = step;
            }
        }
        CHECK(rig.world.is_valid(hinge) == (strength > 20.0f));
        CHECK((broken_at == -1) == (strength > 20.0f));
        CHECK((rig.position().y < -1.0) == (strength < 20.0f));
        rig.world.audit();
    }
}

TEST_CASE("a weld breaks by torque") {
    for (const float strength : {9.9f, 10.4f}) {  // 20 N at 0.5 m, and a peak when the load begins
        Rig rig(true, {0.5, 0.0});
        const JointId weld = rig.world.create_joint(
            WeldJointDef{.body_a = rig.pivot, .body_b = rig.box, .anchor_b = {-0.5f, 0.0f}, .break_torque = strength});
        run(rig.world, 120);
        CHECK(rig.world.is_valid(weld) == (strength > 10.0f));
    }
}

TEST_CASE("invalid joints throw with the value") {
    Rig rig(false);
    const auto refused = [&](const JointDef& def, const char* message) {
        CHECK_THROWS_WITH_AS(rig.world.create_joint(def), doctest::Contains(message), std::invalid_argument);
    };
    const BodyId a = rig.pivot, b = rig.box;
    refused(RevoluteJointDef{.body_a = a, .body_b = b, .limits = JointLimits{1.0f, -1.0f}}, "(1, -1)");
    refused(RevoluteJointDef{.body_a = a, .body_b = b, .spring = JointSpring{0.0f, 1.0f}}, "spring hertz");
    refused(RevoluteJointDef{.body_a = a, .body_b = b, .motor = AngularMotor{1.0f, -1.0f}}, "max_torque");
    refused(PrismaticJointDef{.body_a = a, .body_b = b, .axis_a = {}}, "axis");
    refused(DistanceJointDef{.body_a = a, .body_b = b, .motor = LinearMotor{}}, "rod");
    refused(DistanceJointDef{.body_a = a, .body_b = b, .limits = JointLimits{-1.0f, 1.0f}}, "least length");
    refused(WeldJointDef{.body_a = a, .body_b = b, .break_force = 0.0f}, "break_force");
    refused(FilterJointDef{a, a}, "two bodies");
    const JointId weld = rig.world.create_joint(WeldJointDef{.body_a = a, .body_b = b});
    CHECK_THROWS_AS(rig.world.set_joint(weld, FilterJointDef{a, b}), std::invalid_argument);
}
