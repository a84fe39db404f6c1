// The draw list of hand-made worlds, without GL: the kind, position, size and layer of each primitive.
#include "render/frame/draw_list.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "render/canvas/utf8.hpp"
#include "render/frame/grid.hpp"
#include "render/frame/marking.hpp"
#include "render/hand_made_scene.hpp"
#include "render/style/theme.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::render;
using namespace tumble::test;

namespace {

// 10 pixels a metre, the world point (100, 50) in the middle of 640 x 360.
const View kView{{100.0, 50.0}, 10.0, 640, 360};

DrawList build(const HandMadeScene& s, const View& view = kView) {
    DrawList list;
    build_draw_list(list, s.scene, s.built, view);
    return list;
}

std::vector<Vec2> regular_polygon(int count) {
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
        const SinCos direction = sin_cos(2.0 * kPi * i / count);
        points.push_back({static_cast<float>(direction.cos), static_cast<float>(direction.sin)});
    }
    return points;
}

}  // namespace

TEST_CASE("each shape becomes one instance of its kind, at its position in pixels") {
    HandMadeScene s;
    s.add_dynamic("circle", {101.0, 52.0}, make_circle(0.5f));
    s.add_dynamic("box", {98.0, 50.0}, make_box({2.0f, 1.0f}, 0.1f), 90.0);
    s.add_dynamic("capsule", {100.0, 49.0}, make_capsule({-1.0f, 0.0f}, {1.0f, 0.0f}, 0.25f));
    s.add_dynamic("triangle", {103.0, 50.0}, make_polygon(regular_polygon(3)));
    s.add_dynamic("rounded", {106.0, 50.0}, make_polygon(regular_polygon(6), 0.2f));
    const DrawList list = build(s);

    REQUIRE(list.bodies.circles.size() == 1);
    const CircleInstance& circle = list.bodies.circles.at(0);
    CHECK(circle.x == 10.0f);
    CHECK(circle.y == 20.0f);
    CHECK(circle.radius == 5.0f);

    REQUIRE(list.bodies.boxes.size() == 2);
    const BoxInstance& box = list.bodies.boxes.at(0);  // in the order of the bodies
    CHECK(near(box.x, -20.0, kFloat));
    CHECK(box.y == 0.0f);
    CHECK(near(box.radius, 1.0, kFloat));
    // The core is 1.8 x 0.8 m; turned by 90 degrees its longer side points up or down.
    const bool first_is_longer = box.half_x > box.half_y;
    CHECK(near(std::max(box.half_x, box.half_y), 9.0, kFloat));
    CHECK(near(std::min(box.half_x, box.half_y), 4.0, kFloat));
    CHECK(near(std::abs(first_is_longer ? box.axis_y : box.axis_x), 1.0, kFloat));

    const BoxInstance& capsule = list.bodies.boxes.at(1);
    CHECK(capsule.x == 0.0f);
    CHECK(near(capsule.y, -10.0, kFloat));
    CHECK(near(capsule.half_x, 10.0, kFloat));
    CHECK(capsule.half_y == 0.0f);
    CHECK(near(capsule.radius, 2.5, kFloat));

    CHECK(list.bodies.polygons.size() == 1);
    REQUIRE(list.bodies.rounded_polygons.size() == 1);
    CHECK(near(list.bodies.rounded_polygons.at(0).radius, 2.0, kFloat));
    CHECK(list.bodies.mesh.empty());
    CHECK(list.ground.boxes.empty());
}

TEST_CASE("the vertices of a polygon are drawn at those of the body") {
    HandMadeScene s;
    const std::vector<Vec2> corners{{-1.0f, -0.5f}, {1.5f, -0.5f}, {0.25f, 2.0f}};
    const BodyId id = s.add_dynamic("triangle", {103.0, 47.0}, make_polygon(corners), 33.0);
    const DrawList list = build(s);
    REQUIRE(list.bodies.polygons.size() == 1);
    const PolygonInstance& polygon = list.bodies.polygons.at(0);
    const Pose pose = s.built.world.state(id).pose;
    for (std::size_t i = 0; i < PolygonInstance::kVertices; ++i) {
        const double x = polygon.vertices[2 * i], y = polygon.vertices[2 * i + 1];
        const DVec2 drawn{polygon.x + x * polygon.axis_x - y * polygon.axis_y,
                          polygon.y + x * polygon.axis_y + y * polygon.axis_x};
        double nearest = 1e9;
        for (const Vec2 corner : corners)
            nearest = std::min(nearest, length(drawn - kView.to_pixels(transform_point(pose, corner))));
        CHECK(nearest < 1e-4);
        CHECK(std::abs(x) <= polygon.half_x * 1.0001);
        CHECK(std::abs(y) <= polygon.half_y * 1.0001);
    }
}

TEST_CASE("static bodies are grey in a lower layer, and shapes of more than eight vertices become a mesh") {
    HandMadeScene s;
    s.add_static("ground", {100.0, 40.0}, make_box({50.0f, 2.0f}));
    s.add_static("wheel", {100.0, 50.0}, make_polygon(regular_polygon(9)));
    s.add_dynamic("disc", {105.0, 50.0}, make_polygon(regular_polygon(30)));
    const DrawList list = build(s);
    REQUIRE(list.ground.boxes.size() == 1);
    CHECK(list.ground.boxes.at(0).paint.fill == colors_of(Theme::light).static_fill);
    // Two triangles an edge for the strip, n - 2 inside.
    CHECK(list.ground.mesh.size() == 3 * (2 * 9 + 7));
    CHECK(list.bodies.mesh.size() == 3 * (2 * 30 + 28));
}

TEST_CASE("shapes out of view and destroyed bodies are not in the list") {
    HandMadeScene s;
    s.add_dynamic("seen", {131.0, 50.0}, make_circle(0.5f));
    s.add_dynamic("just outside", {133.0, 50.0}, make_circle(0.5f));
    s.add_dynamic("box above", {100.0, 70.0}, make_box({1.0f, 1.0f}));
    s.add_dynamic("triangle below", {100.0, 30.0}, make_polygon(regular_polygon(3)));
    s.add_dynamic("30-gon far left", {0.0, 50.0}, make_polygon(regular_polygon(30)));
    s.add_dynamic("segment", {200.0, 50.0}, make_segment({-1.0f, 0.0f}, {1.0f, 0.0f}));
    const BodyId gone = s.add_dynamic("gone", {100.0, 50.0}, make_circle(0.5f));
    s.built.world.destroy_body(gone);
    const DrawList list = build(s);
    CHECK(list.bodies.circles.size() == 1);
    CHECK(list.bodies.boxes.empty());
    CHECK(list.bodies.polygons.empty());
    CHECK(list.bodies.mesh.empty());
}

TEST_CASE("a radius shows the angle of a circle, and tiny circles have none") {
    HandMadeScene s;
    s.add_dynamic("ball", {100.0, 50.0}, make_circle(2.0f), 90.0);
    const DrawList list = build(s);
    REQUIRE(list.details.boxes.size() == 1);
    const BoxInstance& mark = list.details.boxes.at(0);
    CHECK(near(std::abs(mark.axis_y), 1.0, kFloat));
    CHECK(mark.x == 0.0f);
    CHECK(mark.y > 5.0f);  // between the middle and the rim, 20 pixels up
    CHECK(mark.y < 15.0f);
    View far = kView;
    far.scale = 2.0;
    CHECK(build(s, far).details.boxes.empty());
}

TEST_CASE("a joint has a dot at each anchor, and a line between anchors that are apart") {
    HandMadeScene s;
    const BodyId a = s.add_dynamic("a", {98.0, 50.0}, make_circle(0.2f));
    const BodyId b = s.add_dynamic("b", {102.0, 50.0}, make_circle(0.2f));
    s.built.joints.push_back({s.built.world.create_joint(RevoluteJointDef{a, b, {2.0f, 0.0f}, {-2.0f, 0.0f}}), 0, ""});
    const DrawList hinge = build(s);
    REQUIRE(hinge.details.circles.size() == 1);
    CHECK(hinge.details.circles.at(0).x == 0.0f);
    CHECK(hinge.details.boxes.empty());

    s.built.joints.push_back({s.built.world.create_joint(DistanceJointDef{a, b, {}, {}, 4.0f}), 1, ""});
    const DrawList rod = build(s);
    CHECK(rod.details.circles.size() == 3);
    REQUIRE(rod.details.boxes.size() == 1);
    CHECK(near(rod.details.boxes.at(0).half_x, 20.0, kFloat));
}

TEST_CASE("a pulley is drawn over two wheels, a gear from its axle to the nearest point of the rail") {
    HandMadeScene s;
    World& world = s.built.world;
    const BodyId a = s.add_dynamic("a", {98.0, 50.0}, make_circle(0.2f));
    const BodyId b = s.add_dynamic("b", {102.0, 50.0}, make_circle(0.2f));
    const JointId rope = world.create_joint(PulleyJointDef{
        .body_a = a, .body_b = b, .ground_anchor_a = {98.0, 54.0}, .ground_anchor_b = {102.0, 54.0}, .length = 8.0f});
    s.built.joints = {{rope, 0, ""}};
    const DrawList pulley = build(s);
    // Two wheels of 0.25 m beside the ground anchors, the axle of each, and the anchors of the bodies.
    REQUIRE(pulley.details.circles.size() == 6);
    CHECK(near(pulley.details.circles.at(0).x, -17.5, kFloat));
    CHECK(near(pulley.details.circles.at(2).x, 17.5, kFloat));
    for (const std::size_t wheel : {0u, 2u}) {
        CHECK(near(pulley.details.circles.at(wheel).y, 40.0, kFloat));
        CHECK(near(pulley.details.circles.at(wheel).radius, 2.5, kFloat));
    }
    CHECK(near(pulley.details.boxes.front().half_x, 20.0, kFloat));  // straight up from the body to its wheel
    CHECK(near(pulley.details.boxes.back().half_x, 20.0, kFloat));

    const BodyId wall = s.add_dynamic("wall", {100.0, 42.0}, make_circle(0.2f));
    const JointId hinge = world.create_joint(RevoluteJointDef{.body_a = wall, .body_b = a, .anchor_a = {-2.0f, 8.0f}});
    const JointId rail = world.create_joint(PrismaticJointDef{
        .body_a = wall, .body_b = b, .anchor_a = {2.0f, 8.0f}, .anchor_b = {0.0f, 3.0f}, .axis_a = {0.0f, 2.0f}});
    s.built.joints = {{world.create_joint(GearJointDef{.joint_a = hinge, .joint_b = rail}), 0, ""}};
    const DrawList gear = build(s);
    REQUIRE(gear.details.circles.size() > 2);  // those of the gear, then those of joints that the scene does not have
    CHECK(near(gear.details.circles.at(0).x, -20.0, kFloat));
    CHECK(near(gear.details.circles.at(1).x, 20.0, kFloat));
    CHECK(gear.details.circles.at(1).y == 0.0f);  // not at the anchor, 3 m up the rail
}

TEST_CASE("a spring is a coil, and a rope without slack a line") {
    HandMadeScene s;
    const BodyId a = s.add_dynamic("a", {98.0, 50.0}, make_circle(0.2f));
    const BodyId b = s.add_dynamic("b", {102.0, 50.0}, make_circle(0.2f));
    DistanceJointDef joint{a, b, {}, {}, 4.0f};
    joint.spring = JointSpring{1.0f, 0.5f};
    const JointId spring = s.built.world.create_joint(joint);
    s.built.joints = {{spring, 0, ""}};
    CHECK(build(s).details.boxes.size() > 10);
    s.built.world.destroy_joint(spring);
    joint.spring.reset();
    joint.limits = JointLimits{0.0f, 4.0f};
    s.built.joints = {{s.built.world.create_joint(joint), 0, ""}};
    const DrawList rope = build(s);
    REQUIRE(rope.details.boxes.size() == 1);
    CHECK(near(rope.details.boxes.at(0).half_x, 20.0, kFloat));
    CHECK(rope.details.circles.size() == 2);
}

TEST_CASE("the solid side of a chain, on the left of its direction, has a band that fades") {
    const std::vector<Vec2> points{{10.0f, 0.0f}, {0.0f, 0.0f}, {-10.0f, 0.0f}};  // leftwards: solid below
    for (const bool two_sided : {false, true}) {
        HandMadeScene s;
        s.add("ground", BodyType::static_body, {100.0, 50.0}, make_chain(points, false));
        ChainGeometry chain{{}, false, two_sided};
        for (const Vec2 point : points) chain.points.push_back(DVec2(point));
        s.scene.bodies.at(0).shapes = {{chain, "", ""}};
        const DrawList list = build(s);
        CHECK(list.ground.boxes.size() == 2);
        CHECK(list.ground.mesh.size() == (two_sided ? 0 : 12));  // two triangles a segment
        for (const MeshVertex& vertex : list.ground.mesh) {
            CHECK((vertex.y == 0.0f) == (vertex.paint.fill.a != 0));
            CHECK(vertex.y <= 0.0f);
        }
    }
}

TEST_CASE("grid lines lie on whole pixels at round coordinates, also far from the origin") {
    for (const double x : {0.0, 123456.7}) {
        Layer layer;
        const View view{{x, 0.3}, 37.0, 641, 360};
        add_grid(layer, view);
        int vertical = 0;
        REQUIRE(layer.mesh.size() > 6 * 10);
        for (std::size_t i = 0; i < layer.mesh.size(); i += 6) {  // two triangles to a line
            const float left = layer.mesh[i].x, right = layer.mesh[i + 1].x;
            if (right - left != 1.0f) continue;
            const float middle = 0.5f * (left + right);
            CHECK(middle == std::floor(middle));  // 641 columns: the middle of the frame is the middle of a pixel
            // 360 rows, half the detail of 720: lines at least 18 pixels apart, so every 50 cm.
            const double steps = view.to_world({middle, 0.0}).x / 0.5;
            CHECK(std::abs(steps - std::round(steps)) * 0.5 < 0.51 / view.scale);
            ++vertical;
        }
        CHECK(vertical > 10);
    }
}

TEST_CASE("where doubles are farther apart than grid lines, there are none") {
    Layer layer;
    add_grid(layer, {{1e6, 1e6}, 1e13, 1280, 720});  // neighbours are 1e-10 m apart, a thousand pixels
    CHECK(layer.mesh.empty());
}

TEST_CASE("a round length is the least of 1, 2 or 5 times a power of ten that is long enough") {
    CHECK(round_length_from(1.0).metres() == 1.0);
    CHECK(round_length_from(1.01).metres() == 2.0);
    CHECK(round_length_from(2.3).metres() == 5.0);
    CHECK(round_length_from(5.1).metres() == 10.0);
    CHECK(round_length_from(0.001).metres() == 0.001);
    CHECK(round_length_from(0.0003).metres() == 0.0005);
    CHECK(round_length_from(1e3).metres() == 1e3);
    CHECK(to_string(round_length_from(0.4)) == "50 cm");
    CHECK(to_string(round_length_from(17.0)) == "20 m");
    CHECK(to_string(round_length_from(900.0)) == "1 km");
    CHECK(to_string(round_length_from(0.004)) == "5 mm");
}

TEST_CASE("text is read as UTF-8, with U+FFFD for each malformed byte") {
    const auto read = [](std::string_view text) {
        std::u32string points;
        while (!text.empty()) points += take_code_point(text);
        return points;
    };
    CHECK(read("a\u00e9\u4e2d\U0001F600") == U"a\u00e9\u4e2d\U0001F600");
    CHECK(read("\xc3") == U"\ufffd");
    CHECK(read("\xe4\xb8x") == U"\ufffd\ufffdx");
    CHECK(read("\x80 \xff") == U"\ufffd \ufffd");
}

TEST_CASE("a sensor is a faint area with a dashed edge, in a layer below the bodies, without an orientation mark") {
    HandMadeScene s;
    for (const BodyType type : {BodyType::static_body, BodyType::dynamic_body}) {
        const BodyId body = s.add("gate", type, {100.0, 50.0}, {});
        s.built.world.add_shape(body, {.shape = make_box({10.0f, 4.0f}), .sensor = true});
    }
    const DrawList list = build(s);
    CHECK(list.ground.boxes.empty());
    CHECK(list.bodies.boxes.empty());
    CHECK(list.details.boxes.empty());
    double dashes = 0.0, areas = 0.0;
    for (const BoxInstance& box : list.sensors.boxes) {
        const bool is_area = box.half_y > 10.0f;  // 100 x 40 pixels
        if (is_area) CHECK(box.paint.fill.a < 128);
        (is_area ? areas : dashes) += is_area ? 1.0 : 2.0 * double{box.half_x};
    }
    CHECK(areas == 2.0);
    // Of two outlines of 280 pixels each 6 of 11, give or take one dash at the end of an outline.
    CHECK(near(dashes, 2.0 * 280.0 * 6.0 / 11.0, absolute(2.0 * 6.0)));
}

TEST_CASE("a marking outlines bodies and regions in view and points at those that are not") {
    HandMadeScene s;
    const BodyId seen = s.add_dynamic("seen", {100.0, 50.0}, make_box({2.0f, 2.0f}));
    const BodyId below = s.add_dynamic("below", {100.0, -900.0}, make_box({2.0f, 2.0f}));
    Layer layer;
    add_marking(layer, kView, s.built.world, {.bodies = {seen}});
    CHECK(layer.boxes.size() == 4);
    layer.clear();
    add_marking(layer, kView, s.built.world,
                {.regions = {{DVec2{90.0, 45.0}, {95.0, 45.0}, {95.0, 48.0}, {90.0, 48.0}}}});
    REQUIRE(layer.boxes.size() == 4);
    CHECK(near(layer.boxes.at(0).x, -75.0, kFloat));  // the lower edge, from -10 m to -5 m of the middle
    CHECK(near(layer.boxes.at(0).y, -50.0, kFloat));
    layer.clear();
    add_marking(layer, kView, s.built.world, {.bodies = {below}});
    REQUIRE(layer.boxes.size() == 3);
    CHECK(layer.boxes.at(0).y < -140.0f);  // near the lower edge, 180 pixels below the middle
    CHECK(near(layer.boxes.at(0).axis_y, -1.0, kFloat));
}
