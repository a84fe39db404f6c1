// Box2D v3 as a third engine, in a build that has it, and its absence in one that does not.
#include <doctest/doctest.h>

#include <cmath>

#include "reference/box2d_v3/v3_queries.hpp"
#include "reference/box2d_v3/v3_world.hpp"
#include "reference/parity/parity.hpp"
#include "support/near.hpp"
#include "tumble/scene_file.hpp"

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
