// Joints of scene files: each key arrives in the definition of its kind, in the unit of the world.
#include <doctest/doctest.h>

#include <string>

#include "support/near.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_world.hpp"

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
    return std::get<Def>(built.world.joint(built.joints.at(0).id));
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

TEST_CASE("omitted keys of a joint are absent, and it does not break") {
    const auto def = built_def<RevoluteJointDef>(R"("type": "revolute", "anchor": [2, 0])");
    CHECK(def.reference_angle == -kQuarterTurn);
    CHECK_FALSE(def.limits.has_value());
    CHECK_FALSE(def.motor.has_value());
    CHECK_FALSE(def.spring.has_value());
    CHECK(def.break_force == kUnbreakable);
}

TEST_CASE("an axis is in world coordinates with a world anchor, in those of the first body with local anchors") {
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

TEST_CASE("the keys of welds, motors, mouse joints and filters arrive in their definitions") {
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
    CHECK(std::holds_alternative<FilterJointDef>(filtered.world.joint(filtered.joints.at(0).id)));
}

TEST_CASE("a pulley has its wheels in the world, and a rope that fits the initial poses") {
    // a is at the origin, turned by 90 degrees; b at (4, 0).
    const auto pulley = built_def<PulleyJointDef>(
        R"("type": "pulley", "anchors": [[1, 0], [0, 1]], "ground_anchors": [[0, 4], [4, 6]], "ratio": 2, "break_force": 70)");
    CHECK(pulley.anchor_a == Vec2{1.0f, 0.0f});
    CHECK(pulley.anchor_b == Vec2{0.0f, 1.0f});
    CHECK(pulley.ground_anchor_a == DVec2{0.0, 4.0});
    CHECK(pulley.ground_anchor_b == DVec2{4.0, 6.0});
    CHECK(pulley.ratio == 2.0f);
    CHECK(pulley.break_force == 70.0f);
    CHECK(pulley.length == 3.0f + 2.0f * 5.0f);  // from (0, 1) and (4, 1)
    CHECK(built_def<PulleyJointDef>(
              R"("type": "pulley", "anchors": [[0, 0], [0, 0]], "ground_anchors": [[0, 4], [4, 6]], "length": 8)")
              .length == 8.0f);
}

TEST_CASE("a gear may precede its joints, and acts on their second bodies") {
    const SceneWorld built = build_world(parse_scene(R"({"format": 1, "bodies": [
        {"name": "wall", "type": "static"}, {"name": "a", "position": [1, 0]}, {"name": "b", "position": [5, 0]}],
        "joints": [
        {"type": "gear", "name": "teeth", "joints": ["hinge", "rail"], "ratio": -0.25, "break_torque": 7},
        {"type": "prismatic", "name": "rail", "bodies": ["wall", "b"], "anchor": [5, 0], "axis": [0, 1]},
        {"type": "revolute", "name": "hinge", "bodies": ["wall", "a"], "anchor": [1, 0]}]})",
                                                     "gear.json"));
    REQUIRE(built.joints.size() == 3);
    CHECK(built.joints.at(2).name == "teeth");
    CHECK(built.joints.at(2).source == 0);
    const auto& gear = std::get<GearJointDef>(built.world.joint(built.joints.at(2).id));
    CHECK(gear.joint_a == built.joints.at(1).id);
    CHECK(gear.joint_b == built.joints.at(0).id);
    CHECK(gear.body_a == built.bodies.at(1).id);
    CHECK(gear.body_b == built.bodies.at(2).id);
    CHECK(gear.ratio == -0.25f);
    CHECK(gear.break_torque == 7.0f);
}

TEST_CASE("a repeated gear connects copy after copy of its joints, a repeated pulley moves its wheels along") {
    const auto text = [](const std::string& columns) {
        return R"({"format": 1, "bodies": [
        {"name": "wall", "type": "static"},
        {"name": "wheel", "position": [0, 0], "repeat": {"grid": {"columns": 4, "spacing": [3, 0]}}},
        {"name": "weight", "position": [0, -5], "repeat": {"grid": {"columns": 4, "spacing": [3, 0]}}}],
        "joints": [
        {"type": "revolute", "name": "axle", "bodies": ["wall", "wheel[0]"], "anchor": [0, 0], "repeat": {"columns": 4}},
        {"type": "gear", "name": "train", "joints": ["axle[0]", "axle[1]"], "repeat": {"columns": )" +
               columns + R"(}},
        {"type": "pulley", "bodies": ["weight[0]", "weight[1]"], "anchors": [[0, 0], [0, 0]],
         "ground_anchors": [[0, -1], [3, -1]], "repeat": {"columns": 3}}]})";
    };
    const SceneWorld built = build_world(parse_scene(text("3"), "train.json"));
    REQUIRE(built.joints.size() == 10);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& pulley = std::get<PulleyJointDef>(built.world.joint(built.joints[4 + i].id));
        const double shift = 3.0 * static_cast<double>(i);
        CHECK(pulley.ground_anchor_a == DVec2{shift, -1.0});
        CHECK(pulley.ground_anchor_b == DVec2{shift + 3.0, -1.0});
        CHECK(pulley.length == 8.0f);
        const auto& gear = std::get<GearJointDef>(built.world.joint(built.joints[7 + i].id));
        CHECK(built.joints[7 + i].name == "train[" + std::to_string(i) + "]");
        CHECK(gear.joint_a == built.joints[i].id);
        CHECK(gear.joint_b == built.joints[i + 1].id);
    }
    CHECK_THROWS_WITH_AS(parse_scene(text("4"), "train.json"),
                         doctest::Contains(R"(needs 3 copies after "axle[1]"; there are 2)"), SceneError);
}

TEST_CASE("a repeated joint joins copy after copy, its anchor at the same point of each") {
    // Four planks on a ring, each turned by its angle: the hinge at the end of the first is at the end of each.
    const SceneWorld built = build_world(parse_scene(R"({"format": 1, "bodies": [
        {"name": "post", "type": "static"},
        {"name": "plank", "repeat": {"ring": {"count": 4, "radius": 5, "turn": true}}, "shapes": [{"box": {"size": [0.2, 2]}}]}],
        "joints": [
        {"type": "revolute", "name": "link", "bodies": ["plank[0]", "plank[1]"], "anchor": [5, 1], "repeat": {"columns": 3}},
        {"type": "prismatic", "name": "rail", "bodies": ["post", "plank[1]"], "anchor": [0, 5], "axis": [0, 1], "repeat": {"columns": 3}}]})",
                                                     "ring.json"));
    REQUIRE(built.joints.size() == 6);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& link = std::get<RevoluteJointDef>(built.world.joint(built.joints[i].id));
        CHECK(built.joints[i].name == "link[" + std::to_string(i) + "]");
        CHECK(built.joints[i].source == 0);
        CHECK(link.body_a == built.bodies[1 + i].id);
        CHECK(link.body_b == built.bodies[2 + i].id);
        CHECK(length(link.anchor_a - Vec2{0.0f, 1.0f}) < 1e-6f);
        CHECK(length(link.anchor_b - Vec2{-4.0f, -5.0f}) < 1e-6f);  // the second stands at (0, 5), turned by a quarter
        const auto& rail = std::get<PrismaticJointDef>(built.world.joint(built.joints[3 + i].id));
        CHECK(rail.body_a == built.bodies.at(0).id);
        CHECK(rail.body_b == built.bodies[2 + i].id);
        CHECK(length(rail.anchor_b) < 1e-6f);  // (0, 5) is the centre of the first one that it holds
        const double turned = kPi / 2.0 * static_cast<double>(i + 1);
        CHECK(length(rail.axis_a - to_float(DVec2{sin_cos(turned).cos, sin_cos(turned).sin})) < 1e-6f);
    }
}

TEST_CASE("rows of a repeated joint start row_step copies on") {
    const SceneWorld built = build_world(parse_scene(R"({"format": 1, "bodies": [
        {"name": "ball", "repeat": {"grid": {"columns": 3, "rows": 2}}, "shapes": [{"circle": {"radius": 0.4}}]}],
        "joints": [{"type": "revolute", "bodies": ["ball[0]", "ball[1]"], "anchors": [[0.5, 0], [-0.5, 0]],
                    "repeat": {"columns": 2, "rows": 2, "row_step": 3}}]})",
                                                     "net.json"));
    REQUIRE(built.joints.size() == 4);
    const std::size_t firsts[] = {0, 1, 3, 4};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& hinge = std::get<RevoluteJointDef>(built.world.joint(built.joints[i].id));
        CHECK(hinge.body_a == built.bodies[firsts[i]].id);
        CHECK(hinge.body_b == built.bodies[firsts[i] + 1].id);
    }
}

TEST_CASE("the anchor on a body that is not repeated moves by the spacing of the joint's repeat") {
    // Six balls 2 m below a beam that is turned by a quarter: its x axis points up, its y axis to the left.
    for (const bool beam_is_first : {true, false}) {
        CAPTURE(beam_is_first);
        const std::string bodies = beam_is_first ? R"(["beam", "ball[0]"], "anchors": [[1, -3], [0, 0.25]])"
                                                 : R"(["ball[0]", "beam"], "anchors": [[0, 0.25], [1, -3]])";
        const SceneWorld built = build_world(parse_scene(R"({"format": 1, "bodies": [
            {"name": "beam", "type": "static", "position": [5, 7], "angle": 90},
            {"name": "ball", "repeat": {"grid": {"columns": 3, "rows": 2}}, "shapes": [{"circle": {"radius": 0.4}}]}],
            "joints": [{"type": "distance", "bodies": )" + bodies +
                                                             R"(, "repeat": {"columns": 3, "rows": 2, "row_step": 3,
                                                                             "spacing": [0.5, -2]}}]})",
                                                         "cradle.json"));
        REQUIRE(built.joints.size() == 6);
        for (std::size_t i = 0; i < 6; ++i) {
            const auto& rod = std::get<DistanceJointDef>(built.world.joint(built.joints[i].id));
            const Vec2 on_beam = beam_is_first ? rod.anchor_a : rod.anchor_b,
                       on_ball = beam_is_first ? rod.anchor_b : rod.anchor_a;
            CHECK(on_beam == Vec2{1.0f + 0.5f * static_cast<float>(i % 3), i < 3 ? -3.0f : -5.0f});
            CHECK(on_ball == Vec2{0.0f, 0.25f});
            CHECK((beam_is_first ? rod.body_b : rod.body_a) == built.bodies[1 + i].id);
        }
        // The rod of the first ball: from (5, 7) + (3, 1) to (0, 0.25).
        const auto& first = std::get<DistanceJointDef>(built.world.joint(built.joints[0].id));
        CHECK(test::near(first.length, std::hypot(8.0, 7.75), test::kFloat));
    }
}

TEST_CASE("a spacing is refused where it would have no effect") {
    const auto error_of = [](const std::string& joint) -> std::string {
        try {
            parse_scene(R"({"format": 1, "bodies": [{"name": "ball", "repeat": {"grid": {"columns": 3}},
                "shapes": [{"circle": {"radius": 0.4}}]}, {"name": "beam", "type": "static"}], "joints": [)" +
                            joint + "]}",
                        "row.json");
        } catch (const SceneError& error) {
            return error.diagnostics.front().pointer + ": " + error.diagnostics.front().message;
        }
        return "";
    };
    const std::string repeat = R"(, "repeat": {"columns": 2, "spacing": [1, 0]}})";
    CHECK(error_of(R"({"type": "distance", "bodies": ["beam", "ball[0]"], "anchors": [[0, 3], [0, 0]])" + repeat) ==
          "");
    CHECK(error_of(R"({"type": "revolute", "bodies": ["beam", "ball[0]"], "anchor": [0, 3])" + repeat) ==
          "/joints/0/repeat/spacing: needs \"anchors\"");
    CHECK(error_of(R"({"type": "distance", "bodies": ["ball[0]", "ball[1]"], "anchors": [[0, 0], [0, 0]])" + repeat) ==
          "/joints/0/repeat/spacing: moves the anchor on a body that is not repeated, and both bodies are copies");
    const std::string hinge =
        R"({"type": "revolute", "name": "h", "bodies": ["beam", "ball[0]"], "anchor": [0, 0], "repeat": {"columns": 3}}, )";
    CHECK(error_of(hinge + R"({"type": "gear", "joints": ["h[0]", "h[1]"])" + repeat) ==
          "/joints/1/repeat/spacing: a gear has no anchors");
}

TEST_CASE("a repeated joint is refused where copies are missing or joined twice") {
    const auto error_of = [](const std::string& repeat) -> std::string {
        try {
            parse_scene(R"({"format": 1, "bodies": [{"name": "ball", "repeat": {"grid": {"columns": 3, "rows": 2}}}],
                "joints": [{"type": "filter", "bodies": ["ball[0]", "ball[1]"], "repeat": )" +
                            repeat + "}]}",
                        "net.json");
        } catch (const SceneError& error) {
            return error.diagnostics.front().pointer + ": " + error.diagnostics.front().message;
        }
        return "";
    };
    CHECK(error_of(R"({"columns": 5})").empty());
    CHECK(error_of(R"({"columns": 6})") == "/joints/0/repeat: needs 5 copies after \"ball[1]\"; there are 4");
    CHECK(error_of(R"({"columns": 2, "rows": 2})") == "/joints/0/repeat: has rows that join the same copies twice");
    CHECK(error_of(R"({"columns": 1000000, "rows": 1000000, "row_step": 1000000})")
              .starts_with("/joints/0: brings the number of joints to 1000000000000"));
}
