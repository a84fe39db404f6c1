// The R.U.B.E. importer, on small files and on a large export that the test writes.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

#include "support/near.hpp"
#include "support/rube_export.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_import.hpp"
#include "tumble/scene_world.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

const std::filesystem::path kRubeData = std::filesystem::path(TUMBLE_SOURCE_DIR) / "tests/import/data";

int count_of(const ImportedScene& imported, const std::string& feature) {
    for (const ImportNote& note : imported.notes)
        if (note.feature == feature) return note.count;
    return 0;
}

const SceneBody& body_of(const ImportedScene& imported, const std::string& name) {
    for (const SceneBody& body : imported.scene.bodies)
        if (body.name == name) return body;
    FAIL("no body ", name);
    throw std::logic_error("unreachable");
}

}  // namespace

TEST_CASE("bodies, fixtures and materials are imported in scene units") {
    const ImportedScene imported = import_rube(kRubeData / "rube_small.json");
    const Scene& scene = imported.scene;
    CHECK(scene.name == "rube_small");
    CHECK(scene.world.gravity.y == static_cast<double>(-9.81f));
    CHECK(scene.world.steps_per_second == 50.0);
    CHECK(scene.world.sleeping);
    CHECK(!scene.world.continuous);     // missing is false
    REQUIRE(scene.bodies.size() == 7);  // the last one for the image of the world

    const SceneBody& crate = body_of(imported, "crate");
    CHECK(crate.type == BodyType::dynamic_body);
    CHECK(crate.position == DVec2(1, 2));
    CHECK(near(crate.angle, 90.0, relative(0x1p-24)));  // pi / 2 as a float
    CHECK(near(crate.angular_velocity, 360.0 / kPi, kDouble));
    CHECK(crate.linear_damping == 0.1);
    CHECK(crate.gravity_scale == 1.0);
    CHECK(crate.custom == R"({"customProperties": [{"name": "colour", "string": "red"}]})");
    CHECK(crate.shapes.at(0).custom == R"({"name": "side"})");
    CHECK(std::get<PolygonGeometry>(crate.shapes.at(0).geometry).vertices.size() == 4);

    CHECK(crate.bullet);
    CHECK(crate.awake);
    CHECK(body_of(imported, "crate_2").gravity_scale == 0.0);
    CHECK_FALSE(body_of(imported, "crate_2").bullet);
    CHECK_FALSE(body_of(imported, "crate_2").awake);  // missing is false
    const SceneBody& fixed = body_of(imported, "crate_2");
    REQUIRE(fixed.shapes.size() == 2);
    CHECK_FALSE(fixed.shapes.at(0).sensor);
    CHECK(fixed.shapes.at(1).sensor);
    CHECK(fixed.fixed_rotation);
    CHECK(fixed.mass.value().mass == 5.0);  // and not the pi / 2 kg of its disc
    CHECK(fixed.mass.value().inertia == 0.0);
    CHECK(crate.shapes.at(0).filter.value().group == -1);
    CHECK_FALSE(crate.mass.value_or(SceneMass{}).mass != 0.0);  // 2 kg and 1/3 kg m^2, as its shape
    CHECK(body_of(imported, "body_3").type == BodyType::kinematic_body);
    CHECK_FALSE(body_of(imported, "off").enabled);
    CHECK(body_of(imported, "off").shapes.size() == 1);
    CHECK(body_of(imported, "off").mass.value().mass == 1.0);  // none is 1 kg
    CHECK(std::holds_alternative<OutlineGeometry>(body_of(imported, "notch").shapes.at(0).geometry));
}

TEST_CASE("chains and edges are two-sided, closed chains are loops") {
    const ImportedScene imported = import_rube(kRubeData / "rube_small.json");
    const std::vector<SceneShape>& shapes = body_of(imported, "ground").shapes;
    REQUIRE(shapes.size() == 4);
    const ChainGeometry& closed = std::get<ChainGeometry>(shapes[0].geometry);
    CHECK(closed.points.size() == 4);
    CHECK(closed.loop);
    CHECK(closed.two_sided);
    CHECK(std::get<SegmentGeometry>(shapes[1].geometry).to == DVec2(-9, 4));
    CHECK(std::get<SegmentGeometry>(shapes[2].geometry).from == DVec2(9, 0));
    CHECK(std::get<ChainGeometry>(shapes[3].geometry).loop);
    for (const SceneShape& shape : shapes) CHECK(shape.material == shapes[0].material);
}

TEST_CASE("missing friction and restitution are 0, not the engine's defaults") {
    const ImportedScene imported = import_rube(kRubeData / "rube_small.json");
    const std::string& name = body_of(imported, "crate").shapes.at(0).material;
    for (const SceneMaterial& material : imported.scene.materials) {
        if (material.name != name) continue;
        CHECK(material.density == 2.0);
        CHECK(material.friction == 0.0);
        CHECK(material.restitution == 0.25);
    }
    CHECK(imported.scene.materials.size() == 5);  // ground, crate, ball, off, notch
}

TEST_CASE("joints are imported with local anchors and degrees") {
    const ImportedScene imported = import_rube(kRubeData / "rube_small.json");
    REQUIRE(imported.scene.joints.size() == 12);
    const SceneJoint& hinge = imported.scene.joints.at(0);
    CHECK(hinge.type == SceneJointType::revolute);
    CHECK(hinge.body_a == "ground");
    CHECK(hinge.body_b == "crate");
    CHECK(hinge.anchors.value().first == DVec2(1, 2));
    CHECK(near(hinge.reference_angle.value(), 90.0, relative(0x1p-24)));
    CHECK(near(hinge.limits.value().upper, 180.0 / kPi, kDouble));
    CHECK(!hinge.motor.has_value());
    CHECK(hinge.collide_connected);
    const SceneJoint& rod = imported.scene.joints.at(1);
    CHECK(rod.name == "hinge_2");
    CHECK(rod.body_a == "body_3");
    CHECK(rod.length == 4.0);
    CHECK(rod.spring.value().hertz == 2.0);
    const SceneJoint& wheel = imported.scene.joints.at(2);
    CHECK(wheel.type == SceneJointType::wheel);
    CHECK(wheel.axis == DVec2{0.0, 1.0});
    CHECK(near(wheel.motor.value().speed, 360.0 / kPi, kDouble));
    CHECK(wheel.spring.value().damping_ratio == 0.7);
    const SceneJoint& slider = imported.scene.joints.at(3);
    CHECK(slider.type == SceneJointType::prismatic);
    CHECK(slider.axis == DVec2{0.0, 2.0});
    CHECK(slider.limits.value().lower == -1.0);
    CHECK(slider.motor.value().max_force == 9.0);
    CHECK(imported.scene.joints.at(4).angular_spring.value().hertz == 3.0);
    const SceneJoint& rope = imported.scene.joints.at(5);
    CHECK(rope.type == SceneJointType::distance);
    CHECK(rope.limits.value().lower == 0.0);
    CHECK(rope.limits.value().upper == 6.0);
    CHECK(imported.scene.joints.at(6).max_torque == 2.0);
    // The target (2, 5) of the world in the coordinates of the body at (0, 5).
    CHECK(imported.scene.joints.at(7).anchors.value().first == DVec2{2.0, 0.0});
    CHECK(imported.scene.joints.at(8).body_a == "off");
    const SceneJoint& pulley = imported.scene.joints.at(10);
    CHECK(pulley.type == SceneJointType::pulley);
    CHECK(pulley.name == "rope");
    CHECK(pulley.anchors.value().second == DVec2{0.0, 0.25});
    CHECK(pulley.ground_anchors.value() == std::pair(DVec2{1.0, 9.0}, DVec2{3.0, 8.0}));
    CHECK(pulley.ratio == 2.0);
    CHECK(pulley.length == 6.5 + 2.0 * 5.75);
    // The joints of a gear have names, and may come after it: the export's 16 and 5 are the scene's 9 and 3.
    const SceneJoint& gear = imported.scene.joints.at(11);
    CHECK(gear.type == SceneJointType::gear);
    CHECK(gear.name == "teeth");
    CHECK(gear.joint_a == "joint_9");
    CHECK(gear.joint_b == "joint_3");
    CHECK(imported.scene.joints.at(9).name == "joint_9");
    CHECK(imported.scene.joints.at(3).name == "joint_3");
    CHECK(gear.ratio == 2.0);
}

TEST_CASE("features that are not carried over are noted once, with a count") {
    const ImportedScene imported = import_rube(kRubeData / "rube_small.json");
    const std::map<std::string, int> expected = {
        {"repeated body names, numbered", 1},
        {"fixtures without a shape or with a degenerate one, left out", 2},
        {"repeated joint names, numbered", 1},
        {"pulley joints whose ratio is not positive, left out", 2},
        {"gear joints that do not couple two revolute or prismatic joints, left out", 2},
        {"gear joints of ratio 0, left out", 1},
        {"joints of the unknown type \"spaghetti\", left out", 1},
        {"tints of images", 1},
        {"stretched images without corners, shown in the proportions of their files", 1},
        {"images without a file or a size, left out", 1},
        {"images that are not PNG, JPEG or BMP files, left out", 1},
    };
    for (const auto& note : expected) CHECK_MESSAGE(count_of(imported, note.first) == note.second, note.first);
    for (const ImportNote& note : imported.notes) CHECK_MESSAGE(expected.contains(note.feature), note.feature);
    const auto tints = std::ranges::find(imported.notes, "tints of images", &ImportNote::feature);
    CHECK(tints->owners == std::vector<std::string>{"'pictures/a.png'"});
}

TEST_CASE("images belong to their bodies, in their order, and those of the world are behind all bodies") {
    const Scene scene = import_rube(kRubeData / "rube_small.json").scene;
    REQUIRE(scene.bodies.at(1).images.size() == 1);
    const SceneImage& a = scene.bodies[1].images[0];
    CHECK(a.file == "pictures/a.png");
    CHECK(a.center == DVec2{0.5, 0.0});
    CHECK(near(a.angle, 90.0 / kPi, kDouble));
    CHECK(a.height == 2.0);  // of the corners: 4 m by 2 m
    CHECK(a.width == 4.0);
    CHECK(a.flip);
    CHECK(a.opacity == 0.5);
    CHECK(a.order == 1);  // the second of the orders -2.5 and 7
    REQUIRE(scene.bodies.at(0).images.size() == 3);
    CHECK(scene.bodies[0].images[0].order == 0);
    CHECK(scene.bodies[0].images[1].file == "d.BMP");
    CHECK(scene.bodies[0].images[2].file == "e.jpeg");
    CHECK(scene.bodies[0].images[2].order == 1);
    CHECK_FALSE(scene.bodies[0].images[0].width.has_value());
    const SceneBody& world = scene.bodies.back();
    CHECK(world.type == BodyType::static_body);
    CHECK(world.shapes.empty());
    REQUIRE(world.images.size() == 1);
    CHECK(world.images[0].file == "b.png");
    CHECK(world.images[0].order == -2);
}

TEST_CASE("a byte-order mark and a JavaScript wrapper are tolerated") {
    const ImportedScene imported = import_rube(kRubeData / "rube_wrapped.js");
    REQUIRE(imported.scene.bodies.size() == 1);
    CHECK(imported.scene.world.gravity == DVec2(0, 0));
    CHECK(imported.scene.bodies.at(0).name == "ball");
}

TEST_CASE("wrong values are errors at their location") {
    try {
        import_rube(kRubeData / "rube_bad_index.json");
        FAIL("imported");
    } catch (const SceneError& error) {
        REQUIRE(error.diagnostics.size() == 2);
        CHECK(error.diagnostics.at(0).pointer == "/body/1/angle");
        CHECK(error.diagnostics.at(1).pointer == "/joint/0/bodyB");
        CHECK(error.diagnostics.at(1).message == "must be the index of one of 2 bodies, got 2");
        CHECK(error.diagnostics.at(1).line == 5);
    }
}

TEST_CASE("numbers that a scene cannot have are errors at their place in the export") {
    const auto error_of_body = [](const std::string& keys) {
        try {
            parse_rube(R"({"body": [{"type": 2, )" + keys + "}]}", "export.json");
        } catch (const SceneError& error) {
            const Diagnostic& first = error.diagnostics.at(0);
            return first.file + " " + first.pointer + " " + first.message;
        }
        return std::string();
    };
    const auto error_of = [&](const std::string& keys) {
        return error_of_body(R"("fixture": [{"circle": {"radius": 1}, "density": 1}], )" + keys);
    };
    CHECK(error_of(R"("angle": 1)").empty());
    CHECK(error_of(R"("massData-center": {"x": 1e308, "y": 0}, "massData-I": 1)") ==
          "export.json /body/0/massData-center/x must be at most 100000, got 1e+308");
    CHECK(error_of(R"("massData-mass": 1e30)") ==
          "export.json /body/0/massData-mass must be at most 1000000, got 1e+30");
    CHECK(error_of(R"("position": {"x": -2e9, "y": 0})") ==
          "export.json /body/0/position/x must be at least -1000000000, got -2000000000");
    CHECK(error_of(R"("angularVelocity": 1e20)").find("/body/0/angularVelocity must be at most ") != std::string::npos);
    CHECK(error_of_body(R"("fixture": [{"density": -1, "circle": {"radius": 1}}])") ==
          "export.json /body/0/fixture/0/density must be at least 0, got -1");
    CHECK(error_of(R"("linearDamping": -1)") == "export.json /body/0/linearDamping must be at least 0, got -1");
    const ImportedScene bouncy =
        parse_rube(R"({"body": [{"fixture": [{"circle": {"radius": 1}, "restitution": 1.5}]}]})", "bouncy.json");
    CHECK(bouncy.scene.materials.at(0).restitution == 1.0);
    CHECK(count_of(bouncy, "restitutions above 1, which are 1 in the scene") == 1);
}

TEST_CASE("a sleeping body is imported without its velocity, which a scene file does not allow") {
    const ImportedScene imported =
        parse_rube(R"({"body": [{"type": 2, "linearVelocity": {"x": 1, "y": 0}, "angularVelocity": 2},
        {"type": 2, "awake": true, "linearVelocity": {"x": 1, "y": 0}}, {"type": 1, "linearVelocity": {"x": 1, "y": 0}}]})",
                   "asleep.json");
    CHECK(imported.scene.bodies.at(0).velocity == DVec2{});
    CHECK(imported.scene.bodies.at(0).angular_velocity == 0.0);
    CHECK(imported.scene.bodies.at(1).velocity == DVec2{1.0, 0.0});
    CHECK(imported.scene.bodies.at(2).velocity == DVec2{1.0, 0.0});
    CHECK(count_of(imported, "velocities of sleeping bodies") == 1);
    CHECK_NOTHROW(build_world(imported.scene));
}

TEST_CASE("an editor project is recognised") {
    CHECK_THROWS_WITH_AS(import_rube(kRubeData / "rube_project.rube"), doctest::Contains("export the scene as JSON"),
                         SceneError);
    CHECK_THROWS_AS(import_rube(kRubeData / "no_such_file.json"), FileError);
}

TEST_CASE("a scene is no export, and is told so") {
    const auto hint_of = [](const std::string& text) {
        try {
            parse_rube(text, "scene.json");
        } catch (const SceneError& error) {
            return error.diagnostics.at(0).hint;
        }
        return std::string("accepted");
    };
    CHECK(hint_of(R"({"format": 1, "bodies": []})") == "it seems to be a scene, which needs no import");
    CHECK(hint_of(R"({"format": 1})") == "");
}

TEST_CASE("a large export arrives with all its bodies, fixtures and joints") {
    const RubeExport made = make_rube_export(300);
    const ImportedScene imported = parse_rube(made.text, "large.json");
    CHECK(static_cast<int>(imported.scene.bodies.size()) == made.bodies);
    int fixtures = 0;
    for (const SceneBody& body : imported.scene.bodies) fixtures += static_cast<int>(body.shapes.size());
    CHECK(fixtures == made.fixtures);
    CHECK(static_cast<int>(imported.scene.joints.size()) == made.joints);
    CHECK(static_cast<int>(build_world(imported.scene).bodies.size()) == made.bodies);
}

TEST_CASE("floats as hexadecimal digits arrive bit for bit") {
    const std::string body = R"({"type": 2, "awake": true, "name": "ball", "position": )" + hex_vector({0.1f, 3.3f}) +
                             R"(, "angle": )" + hex_float(static_cast<float>(kPi / 4.0)) + R"(, "linearVelocity": )" +
                             hex_vector({1.5f, 0.0f}) + R"(, "fixture": [{"circle": {"radius": "3F800000"}}]})";
    const ImportedScene hex =
        parse_rube(R"({"gravity": {"x": 0, "y": "C11CF5C3"}, "body": [)" + body + "]}", "hexfloats.json");
    const SceneBody& ball = body_of(hex, "ball");
    CHECK(hex.scene.world.gravity.y == static_cast<double>(-9.81f));
    CHECK(to_float(ball.position) == Vec2{0.1f, 3.3f});
    CHECK(near(ball.angle, 45.0, relative(0x1p-24)));  // pi / 4 as a float
    CHECK(ball.velocity == DVec2(1.5, 0));
}

TEST_CASE("an inertia below that of a mass point at the centre is replaced, with a warning at its place") {
    // m c^2 = 2 * 3^2 = 18 kg m^2 is more than I = 17. The disc of pi kg has pi / 2 kg m^2 about its centre: of 2 kg,
    // 3 m from the stated centre, 1 + 18 kg m^2.
    const char* const text = R"({"gravity": 0, "body": [{"type": 2, "name": "wheel", "massData-mass": 2,
    "massData-I": 17, "massData-center": {"x": 3, "y": 0},
    "fixture": [{"density": 1, "circle": {"radius": 1, "center": 0}}]},
   {"type": 2, "massData-mass": 2, "massData-I": 17, "massData-center": {"x": 3, "y": 0}}]})";
    const ImportedScene imported = parse_rube(text, "bad.json");
    REQUIRE(imported.scene.bodies.at(0).mass.has_value());
    CHECK(near(imported.scene.bodies[0].mass->inertia, 19.0, relative(1e-6)));
    CHECK(imported.scene.bodies.at(1).mass->inertia == 0.0);
    REQUIRE(imported.warnings.size() == 2);
    CHECK(imported.warnings[0].line == 2);
    CHECK(imported.warnings[0].pointer == "/body/0/massData-I");
    CHECK(imported.warnings[0].message.starts_with("body 'wheel' has a moment of inertia of 17 kg m^2"));
    CHECK(imported.warnings[1].message.starts_with("body 1 has"));
    CHECK(imported.warnings[1].hint == "the body has no shape with an area: it does not rotate");
}

TEST_CASE("notes name the first bodies, and settings of Box2D and of the editor are no notes") {
    std::string bodies;
    for (int i = 0; i < 5; ++i)
        bodies += std::string(i > 0 ? ", " : "") + R"({"type": 2, "name": "sleeper)" + std::to_string(i) +
                  R"(", "linearVelocity": {"x": 1, "y": 0}})";
    const ImportedScene imported = parse_rube(R"({"gravity": 0, "velocityIterations": 8, "positionIterations": 3,
        "collisionbitplanes": {"names": []}, "body": [)" +
                                                  bodies + "]}",
                                              "notes.json");
    REQUIRE(imported.notes.size() == 1);
    CHECK(imported.notes[0].count == 5);
    CHECK(imported.notes[0].owners ==
          std::vector<std::string>{"body 'sleeper0'", "body 'sleeper1'", "body 'sleeper2'"});
}
