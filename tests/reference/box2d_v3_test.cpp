// Box2D v3 as a third engine, in a build that has it, and its absence in one that does not.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "reference/bench/query_cases.hpp"
#include "reference/box2d_v3/v3_queries.hpp"
#include "reference/box2d_v3/v3_world.hpp"
#include "reference/parity/parity.hpp"
#include "support/near.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;
using namespace tumble::reference;
using test::absolute, test::near;

TEST_CASE("a build without Box2D v3 says so") {
    CHECK(has_box2d_v3() == !box2d_v3_version().empty());
    CHECK(has_box2d_v3() == !box2d_v3_build().empty());
}

TEST_CASE("the pose of B relative to A takes points of B into the frame of A") {
    const Pose a{{1e6, -2.0}, make_rotation_degrees(90)}, b{{1e6 + 3.0, -2.0}, make_rotation_degrees(180)};
    // B is 3 m to the right of A, which is turned by 90 degrees: in A's frame it is at (0, -3), turned by 90 degrees.
    const box2d_v3::Place place = relative_place(a, b);
    // The numbers are exact but for the rotations, which are floats.
    CHECK(near(place.x, 0.0, absolute(1e-6)));
    CHECK(near(place.y, -3.0, absolute(1e-6)));
    CHECK(near(place.c, 0.0, absolute(1e-6)));
    CHECK(near(place.s, 1.0, absolute(1e-6)));
}

TEST_CASE("Box2D v3 answers queries about boxes as geometry does" * doctest::skip(!has_box2d_v3())) {
    const Shape box = make_box({2.0f, 2.0f});
    const Pose left{{10.0, 0.0}, {}}, right{{13.0, 0.5}, {}};
    const auto distance = b2_v3_distance({box, box, left, right}, false);
    REQUIRE(distance.has_value());
    CHECK(near(distance->distance, 1.0, absolute(1e-5)));
    CHECK(near(distance->point_a.x, 11.0, absolute(1e-5)));
    CHECK(near(distance->point_b.x, 12.0, absolute(1e-5)));
    CastQuery ray;
    ray.a = box;
    ray.pose_a = left;
    ray.pose_b.position = {6.0, 0.25};
    ray.translation = {4.0, 0.0};
    REQUIRE(query_box2d_v3(ray).has_value());
    CHECK(near(query_box2d_v3(ray)->fraction, 0.75, absolute(1e-6)));
    CastQuery cast;
    cast.kind = CastKind::shape;
    cast.a = cast.b = box;
    cast.pose_a = left;
    cast.pose_b = right;
    cast.translation = {-2.0, 0.0};
    cast.target = b2_target(CastKind::shape);
    REQUIRE(query_box2d_v3(cast).has_value());
    // It ends 0.01 m before the boxes touch, within its tolerance of a quarter of its slop.
    CHECK(query_box2d_v3(cast)->hits);
    CHECK(std::abs(query_box2d_v3(cast)->fraction - 0.495) <= 0.5 * query_box2d_v3(cast)->tolerance);
}

TEST_CASE("the same judge decides over Box2D v3, and tumble's answers are the same beside it" *
          doctest::skip(!has_box2d_v3())) {
    ParityOptions options;
    options.pairs = 2000;
    options.threads = 1;
    const ParityResult box2d = run_parity(options);
    options.opponent = Opponent::box2d_v3;
    const ParityResult v3 = run_parity(options);
    REQUIRE(v3.families.size() == box2d.families.size());
    CHECK(v3.passed());
    CHECK(v3.total().comparisons == box2d.total().comparisons);
    CHECK(v3.total().box2d_refused < v3.total().comparisons / 2);
    CHECK(v3.total().iterations_ours == box2d.total().iterations_ours);
}

TEST_CASE("a scene without joints falls in Box2D v3 as in tumble" * doctest::skip(!has_box2d_v3())) {
    const char* const text =
        R"({"format": 1, "bodies": [{"name": "ball", "position": [0, 9], "shapes": [{"circle": {"radius": 0.5}}]},
        {"position": [0, -1], "type": "static", "shapes": [{"polygon": {"vertices": [[-9, 0], [9, 0], [8, -1], [6, -2], [4, -3], [2, -4],
        [-2, -4], [-4, -3], [-6, -2], [-8, -1]]}}]}]})";
    const Scene scene = parse_scene(text, "scene.json");
    CHECK(V3World::can_hold(scene));
    V3World world(scene);
    for (int i = 0; i < 30; ++i) world.step();
    // Free fall for 0.5 s: 1.25 m, and 0.5 s times half of what gravity adds in a sub-step of 1/240 s, 0.0104 m.
    CHECK(near(world.pose(0).position.y, 9.0 - 1.25 - 0.0104, absolute(1e-3)));
    for (int i = 0; i < 270; ++i) world.step();
    CHECK(near(world.pose(0).position.y, -0.5, absolute(0.02)));  // on the polygon, whose top is at -1 m
}

namespace {

// A body at `position` of a scene without gravity, and of the mass 1 kg, with a joint to the static body `wall` at the
// origin, after 1 s in Box2D v3 and in tumble.
struct Joined {
    Pose v3, tumble;
};
Joined after_one_second(const std::string& body, const std::string& joint) {
    const Scene scene = parse_scene(R"({"format": 1, "world": {"gravity": [0, 0]},
        "materials": {"unit": {"density": 1}},
        "bodies": [{"name": "wall", "type": "static", "shapes": [{"circle": {"radius": 0.1}}]},
        {"name": "box", "shapes": [{"box": {"size": [1, 1]}, "material": "unit"}], )" +
                                        body + R"(}],
        "joints": [{"bodies": ["wall", "box"], )" +
                                        joint + "}]}",
                                    "scene.json");
    REQUIRE(V3World::can_hold(scene));
    V3World v3(scene);
    SceneRun tumble(scene);
    for (int i = 0; i < 60; ++i) {
        v3.step();
        tumble.step();
    }
    return {v3.pose(1), tumble.world().state(tumble.built().bodies[1].id).pose};
}

}  // namespace

TEST_CASE("joints hold in Box2D v3 what they hold in tumble" * doctest::skip(!has_box2d_v3())) {
    // A hinge of a body that turns by 1 rad/s on a circle of 2 m.
    const auto hinge = after_one_second(R"("position": [2, 0], "velocity": [0, 2], "angular_velocity": 57.29578)",
                                        R"("type": "revolute", "anchor": [0, 0])");
    CHECK(near(hinge.v3.position.x, 2.0 * std::cos(1.0), absolute(0.01)));
    CHECK(near(hinge.v3.position.y, 2.0 * std::sin(1.0), absolute(0.01)));
    // A slider whose axis has the direction (0.6, 0.8), to its limit at 0.5 m; a push along y moves it by 0.8 of it.
    const auto slider = after_one_second(
        R"("position": [1, 1], "velocity": [0, 2], "angle": 30)",
        R"("type": "prismatic", "anchors": [[1, 1], [0, 0]], "axis": [0.6, 0.8], "limits": [-0.5, 0.5])");
    CHECK(near(slider.v3.position.x, 1.0 + 0.5 * 0.6, absolute(0.01)));
    CHECK(near(slider.v3.position.y, 1.0 + 0.5 * 0.8, absolute(0.01)));
    CHECK(near(angle(slider.v3.rotation), 30.0 * kPi / 180.0, absolute(0.01)));
    // A rod that keeps its length, a rope that lets the body go to 3 m, a weld that lets it go nowhere.
    const auto rod = after_one_second(R"("position": [2, 0], "velocity": [3, 0])",
                                      R"("type": "distance", "anchors": [[0, 0], [0, 0]])");
    CHECK(near(rod.v3.position.x, 2.0, absolute(0.01)));
    const auto rope = after_one_second(R"("position": [2, 0], "velocity": [3, 0])",
                                       R"("type": "distance", "anchors": [[0, 0], [0, 0]], "limits": [0, 3])");
    CHECK(near(rope.v3.position.x, 3.0, absolute(0.02)));
    const auto weld = after_one_second(R"("position": [2, 0], "velocity": [3, 3], "angle": 30)",
                                       R"("type": "weld", "anchor": [1, 0])");
    CHECK(near(weld.v3.position.x, 2.0, absolute(0.02)));
    CHECK(near(angle(weld.v3.rotation), 30.0 * kPi / 180.0, absolute(0.02)));
    for (const Joined& joined : {hinge, slider, rod, rope, weld})
        CHECK(length(joined.v3.position - joined.tumble.position) < 0.05);
}

TEST_CASE("a motor turns a wheel in Box2D v3 as in tumble, and scenes with other joints are refused" *
          doctest::skip(!has_box2d_v3())) {
    const auto wheel = after_one_second(
        R"("position": [0, 2])",
        R"("type": "wheel", "anchor": [0, 2], "axis": [0, 1], "motor": {"speed": 90, "max_torque": 100},
        "spring": {"hertz": 2, "damping_ratio": 0.7})");
    CHECK(near(angle(wheel.v3.rotation), 0.5 * kPi, absolute(0.05)));
    CHECK(near(angle(wheel.v3.rotation), angle(wheel.tumble.rotation), absolute(0.05)));
    const auto scene_with = [](const std::string& joint) {
        return parse_scene(
            R"({"format": 1, "bodies": [{"name": "wall", "type": "static"}, {"name": "box", "position": [1, 0],
            "shapes": [{"circle": {"radius": 0.5}}]}], "joints": [{"bodies": ["wall", "box"], )" +
                joint + "}]}",
            "scene.json");
    };
    CHECK(V3World::can_hold(scene_with(R"("type": "revolute", "anchor": [0, 0])")));
    CHECK_FALSE(V3World::can_hold(scene_with(R"("type": "revolute", "anchor": [0, 0], "break_force": 5)")));
    CHECK_FALSE(V3World::can_hold(scene_with(R"("type": "motor", "anchor": [0, 0], "max_force": 5)")));
}

TEST_CASE("the timed queries of both give the same sums of answers" * doctest::skip(!has_box2d_v3())) {
    int compared = 0;
    for (const QueryCase& query_case : query_cases()) {
        if (query_case.name.starts_with("time of impact")) continue;  // the two stop at other distances
        CAPTURE(query_case.name);
        const QueryRuns runs = query_case.make(500, 7);
        CHECK(static_cast<bool>(runs.box2d_v3) == !query_case.name.starts_with("1000-gon"));
        if (!runs.box2d_v3) continue;
        // Distances and rays agree to the precision of a float; of overlap Box2D knows that the distance is 0. The
        // pairs of manifolds overlap and have one or two points, of which Box2D v3 keeps those too that are far apart.
        if (query_case.name.starts_with("manifold")) {
            CHECK(runs.box2d_v3() >= runs.tumble());
            CHECK(runs.box2d_v3() <= 1000.0);
        } else {
            const bool overlap = query_case.name.find("overlapping") != std::string::npos;
            CHECK(near(runs.box2d_v3(), overlap ? 0.0 : runs.tumble(), absolute(500 * 1e-5)));
        }
        ++compared;
    }
    CHECK(compared > 15);
}
