// Queries against a test of every shape, and by hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "support/near.hpp"
#include "support/worlds.hpp"
#include "tumble/cast.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

const Shape kBox = make_box({1.0f, 1.0f});

struct Draw {
    std::mt19937 random;
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(random() >> 8) * 0x1p-24);
    }
};

// Shapes of all kinds in a square of 20 m about a point, some of them sensors.
World make_field(DVec2 origin, Draw& draw) {
    World world = weightless();
    for (int i = 0; i < 150; ++i) {
        BodyDef def;
        def.type = i % 3 == 0 ? BodyType::static_body : BodyType::dynamic_body;
        const double x = draw.between(-10.0, 10.0), y = draw.between(-10.0, 10.0);
        def.pose = {origin + DVec2{x, y}, make_rotation(draw.between(-3.0, 3.0))};
        const BodyId body = world.create_body(def);
        const auto size = static_cast<float>(draw.between(0.1, 0.9));
        const Vec2 corners[] = {{-size, -size}, {size, -0.5f * size}, {0.2f * size, size}};
        const Shape shape = i % 4 == 0   ? make_circle(size)
                            : i % 4 == 1 ? make_box({size, 0.5f}, 0.05f)
                            : i % 4 == 2 ? make_capsule({-size, 0.0f}, {size, 0.1f}, 0.1f)
                                         : make_polygon(corners);
        world.add_shape(body, {.shape = shape, .filter = {.category = 1u << (i % 2)}, .sensor = i % 11 == 0});
    }
    return world;
}

// Calls visit(shape, pose, id) for all that the filter lets through, in id order.
template <class Visitor>
void for_each_seen(const World& world, const QueryFilter& filter, Visitor&& visit) {
    for (const BodyId body : world.bodies())
        for (const ShapeId id : world.shapes(body))
            if ((filter.sensors || !world.is_sensor(id)) && may_meet(filter.shape, world.filter(id)) &&
                body != filter.except)
                visit(world.shape(id), world.state(body).pose, id);
}

}  // namespace

TEST_CASE("rays find what a test of every shape finds, at the origin and 10 km away") {
    for (const DVec2 origin : {DVec2{}, DVec2{10000.0, -7000.0}}) {
        Draw draw{std::mt19937(5)};
        const World world = make_field(origin, draw);
        int hits = 0;
        for (int i = 0; i < 400; ++i) {
            CAPTURE(i);
            const DVec2 from = origin + DVec2{draw.between(-12.0, 12.0), draw.between(-12.0, 12.0)};
            const DVec2 way = i % 10 == 0 ? DVec2{draw.between(-20.0, 20.0), 0.0}
                                          : DVec2{draw.between(-20.0, 20.0), draw.between(-20.0, 20.0)};
            QueryFilter filter;
            filter.sensors = i % 2 == 0;
            filter.shape.mask = i % 3 == 0 ? 1 : 3;
            std::vector<CastHit> expected;
            for_each_seen(world, filter, [&](const Shape& shape, const Pose& pose, ShapeId id) {
                const CastResult cast = cast_ray(shape, pose, from, way);
                if (cast.status == CastStatus::hit)
                    expected.push_back({id, world.body(id), cast.fraction, cast.point, cast.normal});
            });
            std::stable_sort(expected.begin(), expected.end(),
                             [](const CastHit& a, const CastHit& b) { return a.fraction < b.fraction; });
            const std::vector<CastHit> all = world.cast_ray_all(from, way, filter);
            REQUIRE(all.size() == expected.size());
            for (std::size_t k = 0; k < all.size(); ++k) {
                CHECK(all[k].shape == expected[k].shape);
                CHECK(all[k].fraction == expected[k].fraction);
                CHECK(all[k].point == expected[k].point);
            }
            const std::optional<CastHit> first = world.cast_ray(from, way, filter);
            REQUIRE(first.has_value() == !expected.empty());
            if (!first) continue;
            ++hits;
            CHECK(first->shape == expected[0].shape);
            CHECK(first->body == expected[0].body);
            CHECK(first->normal == expected[0].normal);
        }
        CHECK(hits > 120);
        CHECK(hits < 380);
    }
}

TEST_CASE("a cast shape hits first what a test of every shape says") {
    Draw draw{std::mt19937(6)};
    const World world = make_field({}, draw);
    const Shape shape = make_box({0.6f, 0.3f}, 0.05f);
    int hits = 0, inside = 0;
    for (int i = 0; i < 400; ++i) {
        CAPTURE(i);
        const Pose pose{{draw.between(-12.0, 12.0), draw.between(-12.0, 12.0)}, make_rotation(draw.between(-3.0, 3.0))};
        const DVec2 way{draw.between(-10.0, 10.0), draw.between(-10.0, 10.0)};
        std::optional<CastHit> expected;
        for_each_seen(world, {}, [&](const Shape& other, const Pose& other_pose, ShapeId id) {
            const CastResult cast = cast_shape(other, other_pose, shape, pose, way);
            if (cast.status != CastStatus::hit && cast.status != CastStatus::overlapping) return;
            const double fraction = cast.status == CastStatus::hit ? cast.fraction : 0.0;
            if (!expected || fraction < expected->fraction)
                expected = CastHit{id, {}, fraction, cast.point, cast.normal, cast.status == CastStatus::overlapping};
        });
        const std::optional<CastHit> hit = world.cast_shape(shape, pose, way);
        REQUIRE(hit.has_value() == expected.has_value());
        if (!hit) continue;
        ++hits;
        inside += hit->starts_inside;
        CHECK(hit->shape == expected->shape);
        CHECK(hit->fraction == expected->fraction);
        CHECK(hit->starts_inside == expected->starts_inside);
    }
    CHECK(hits > 120);
    CHECK(inside > 40);
    CHECK(inside < hits - 40);
}

TEST_CASE("overlaps and the nearest shape are those that a look at every shape finds") {
    for (const DVec2 origin : {DVec2{}, DVec2{-9000.0, 10000.0}}) {
        Draw draw{std::mt19937(7)};
        const World world = make_field(origin, draw);
        const Shape probe = make_capsule({-0.7f, 0.0f}, {0.7f, 0.0f}, 0.2f);
        const Shape point_shape = make_circle(0.0f);
        std::size_t overlapping = 0;
        for (int i = 0; i < 300; ++i) {
            CAPTURE(i);
            const Pose pose{origin + DVec2{draw.between(-11.0, 11.0), draw.between(-11.0, 11.0)},
                            make_rotation(draw.between(-3.0, 3.0))};
            const DVec2 corner = pose.position + DVec2{draw.between(0.0, 3.0), draw.between(0.0, 3.0)};
            std::vector<ShapeId> shapes, boxes;
            std::optional<ClosestHit> nearest;
            for_each_seen(world, {}, [&](const Shape& other, const Pose& other_pose, ShapeId id) {
                if (distance(other, other_pose, probe, pose).distance <= 0.0) shapes.push_back(id);
                const Aabb box = bounds(other, other_pose);
                if (box.lower.x <= corner.x && pose.position.x <= box.upper.x && box.lower.y <= corner.y &&
                    pose.position.y <= box.upper.y)
                    boxes.push_back(id);
                const DistanceResult gap = distance(other, other_pose, point_shape, {pose.position, {}});
                if (!nearest || gap.distance < nearest->distance)
                    nearest = ClosestHit{id, {}, gap.distance, gap.point_a, gap.normal};
            });
            CHECK(world.overlap_shape(probe, pose) == shapes);
            CHECK(world.overlap_box(pose.position, corner) == boxes);
            const auto found = world.closest(pose.position, std::numeric_limits<double>::infinity());
            REQUIRE(found);
            CHECK(found->shape == nearest->shape);
            CHECK(found->distance == nearest->distance);
            CHECK(found->point == nearest->point);
            const double less = 0.5 * std::abs(nearest->distance);
            CHECK(world.closest(pose.position, less).has_value() == (nearest->distance <= less));
            overlapping += !shapes.empty();
        }
        CHECK(overlapping > 90);
        CHECK(overlapping < 290);
    }
}

// A ray down the y axis onto a unit box at the origin: it enters at y = 0.5, after 2.5 of 4 m.
TEST_CASE("a ray's hit has the point, the normal and the fraction that one works out by hand") {
    World world;
    const BodyId box = add_static(world, {0.0, 0.0}, kBox);
    const auto hit = world.cast_ray({0.25, 3.0}, {0.0, -4.0});
    REQUIRE(hit);
    CHECK(hit->body == box);
    CHECK(near(hit->fraction, 0.625, kDouble));
    CHECK(near(hit->point.x, 0.25, kDouble));
    CHECK(near(hit->point.y, 0.5, kDouble));
    CHECK(hit->normal == DVec2{0.0, 1.0});
    CHECK_FALSE(world.cast_ray({0.25, 0.25}, {0.0, 4.0}));  // from inside
    CHECK_FALSE(world.cast_ray({0.25, 3.0}, {0.0, -4.0}, {.except = box}));
}

TEST_CASE("of two shapes met at once the one with the lower id is the first") {
    World world;
    const BodyId first = add_static(world, {0.0, 0.0}, kBox);
    add_static(world, {0.0, 0.0}, kBox);
    const auto ray = world.cast_ray({3.0, 0.0}, {-4.0, 0.0});
    const auto nearest = world.closest({3.0, 0.0}, 10.0);
    const auto cast = world.cast_shape(make_circle(0.5f), {{3.0, 0.0}, {}}, {-4.0, 0.0});
    REQUIRE(ray);
    REQUIRE(nearest);
    REQUIRE(cast);
    CHECK(ray->body == first);
    CHECK(nearest->body == first);
    CHECK(cast->body == first);
}

TEST_CASE("the distance of two bodies is that of their nearest solid shapes") {
    World world;
    const BodyId a = add_static(world, {0.0, 0.0}, kBox), b = add_dynamic(world, {5.0, 0.0}, make_circle(0.5f));
    const ShapeId arm = world.add_shape(a, {make_box({1.0f, 1.0f}, 0.0f, {2.0f, 0.0f})});
    world.add_shape(a, {.shape = make_box({1.0f, 1.0f}, 0.0f, {3.5f, 0.0f}), .sensor = true});
    const BodyDistance gap = world.distance(a, b);
    CHECK(gap.shape_a == arm);
    CHECK(gap.shape_b == world.shapes(b)[0]);
    CHECK(near(gap.nearest.distance, 2.0, kDouble));
    CHECK(gap.nearest.normal == DVec2{1.0, 0.0});
    const BodyId bare = world.create_body({});
    CHECK(world.distance(a, bare).nearest.status == DistanceStatus::invalid);
}

TEST_CASE("queries refuse what they cannot answer") {
    const World world;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(world.cast_ray({nan, 0.0}, {1.0, 0.0}), std::invalid_argument);
    CHECK_THROWS_AS(world.cast_ray_all({0.0, 0.0}, {0.0, nan}), std::invalid_argument);
    CHECK_THROWS_AS(world.cast_shape(Shape(), {}, {1.0, 0.0}), std::invalid_argument);
    CHECK_THROWS_AS(world.overlap_shape(kBox, {{0.0, 0.0}, {2.0f, 0.0f}}), std::invalid_argument);
    CHECK_THROWS_AS(world.overlap_box({1.0, 0.0}, {0.0, 1.0}), std::invalid_argument);
    CHECK_THROWS_AS(world.closest({0.0, 0.0}, -1.0), std::invalid_argument);
    CHECK_THROWS_AS(world.distance({}, {}), std::invalid_argument);
    CHECK_FALSE(world.closest({0.0, 0.0}, 1.0));
}
