// Joints of scene files: each key arrives in the definition of its kind, in the unit of the world.
#include <doctest/doctest.h>

#include <string>

#include "tumble/scene.hpp"

using namespace tumble;

namespace {

// Two bodies, the first turned by 90 degrees, and one joint.
SceneWorld build_joint(const std::string& keys) {
    return build_world(parse_scene(R"({"format": 1, "bodies": [
        {"name": "a", "angle": 90, "shapes": [{"circle": {"radius": 1}}]},
        {"name": "b", "position": [4, 0], "shapes": [{"circle": {"radius": 1}}]}],
        "joints": [{"bodies": ["a", "b"], )" +
                                       keys + "}]}",
                                   "joint.json"));
}

template <class Def>
Def built_def(const std::string& keys) {
    const SceneWorld built = build_joint(keys);
    return std::get<Def>(built.world.joint(built.joints[0]));
}

constexpr float kQuarterTurn = static_cast<float>(kPi / 2.0);

}  // namespace

TEST_CASE("a hinge has its limits, motor and spring in radians, and its strength") {
    const auto def = built_def<RevoluteJointDef>(
        R"("type": "revolute", "anchor": [2, 0], "reference_angle": 0, "limits": [-90, 180],
           "motor": {"speed": 90, "max_torque": 50}, "spring": {"hertz": 2, "damping_ratio": 0.5},
           "break_force": 900, "break_torque": 70)");
    CHECK(def.anchor_a == Vec2{0.0f, -2.0f});
    CHECK(def.anchor_b == Vec2{-2.0f, 0.0f});
    CHECK(def.limits == JointLimits{-kQuarterTurn, 2.0f * kQuarterTurn});
    CHECK(def.motor == AngularMotor{kQuarterTurn, 50.0f});
    CHECK(def.spring == JointSpring{2.0f, 0.5f});
    CHECK(def.break_force == 900.0f);
    CHECK(def.break_torque == 70.0f);
}

TEST_CASE("what is left out is absent, and nothing breaks") {
    const auto def = built_def<RevoluteJointDef>(R"("type": "revolute", "anchor": [2, 0])");
    CHECK(def.reference_angle == -kQuarterTurn);
    CHECK_FALSE(def.limits.has_value());
    CHECK_FALSE(def.motor.has_value());
    CHECK_FALSE(def.spring.has_value());
    CHECK(def.break_force == kUnbreakable);
}

TEST_CASE("an axis is the world's with a world anchor, the first body's with own anchors") {
    const auto world = built_def<PrismaticJointDef>(
        R"("type": "prismatic", "anchor": [4, 0], "axis": [0, 1], "limits": [-1, 2],
           "motor": {"speed": 3, "max_force": 40})");
    CHECK(world.axis_a == Vec2{1.0f, 0.0f});  // a is turned by 90 degrees: up in the world is its +x
    CHECK(world.limits == JointLimits{-1.0f, 2.0f});
    CHECK(world.motor == LinearMotor{3.0f, 40.0f});
    const auto own = built_def<WheelJointDef>(
        R"("type": "wheel", "anchors": [[0, -4], [0, 0]], "axis": [0, 1], "motor": {"speed": -90, "max_torque": 5})");
    CHECK(own.axis_a == Vec2{0.0f, 1.0f});
    CHECK(own.motor == AngularMotor{-kQuarterTurn, 5.0f});
}

TEST_CASE("a rope is a distance joint with limits, a spring one with a spring") {
    const auto rope =
        built_def<DistanceJointDef>(R"("type": "distance", "anchors": [[0, 0], [0, 0]], "limits": [0, 5])");
    CHECK(rope.length == 4.0f);
    CHECK(rope.limits == JointLimits{0.0f, 5.0f});
    const auto spring = built_def<DistanceJointDef>(
        R"("type": "distance", "anchors": [[0, 0], [0, 0]], "length": 3, "spring": {"hertz": 1})");
    CHECK(spring.length == 3.0f);
    CHECK(spring.spring == JointSpring{1.0f, 0.0f});
}

TEST_CASE("welds, motors, mice and filters") {
    const auto weld = built_def<WeldJointDef>(
        R"("type": "weld", "anchor": [2, 0], "spring": {"hertz": 9}, "angular_spring": {"hertz": 3, "damping_ratio": 1})");
    CHECK(weld.linear_spring == JointSpring{9.0f, 0.0f});
    CHECK(weld.angular_spring == JointSpring{3.0f, 1.0f});
    const auto motor = built_def<MotorJointDef>(
        R"("type": "motor", "anchor": [4, 0], "velocity": [1, 2], "angular_velocity": 90, "max_force": 5, "max_torque": 6)");
    CHECK(motor.velocity == Vec2{1.0f, 2.0f});
    CHECK(motor.angular_velocity == kQuarterTurn);
    CHECK(motor.max_force == 5.0f);
    CHECK(motor.max_torque == 6.0f);
    const auto mouse = built_def<MouseJointDef>(R"("type": "mouse", "anchor": [4, 0], "max_force": 100)");
    CHECK(mouse.anchor_a == Vec2{0.0f, -4.0f});
    CHECK(mouse.spring == JointSpring{5.0f, 0.7f});
    CHECK(mouse.max_force == 100.0f);
    const SceneWorld filtered = build_joint(R"("type": "filter")");
    CHECK(std::holds_alternative<FilterJointDef>(filtered.world.joint(filtered.joints[0])));
}
