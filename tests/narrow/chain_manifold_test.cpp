// Chains: contacts at seams, the range of the normals, and the open side.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "reference/query/random.hpp"
#include "support/near.hpp"
#include "tumble/manifold.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kSpeculative = 0.02;

struct Chain {
    std::vector<Shape> segments;
    std::vector<ChainLink> links;

    Chain(const std::vector<Vec2>& points, bool loop, bool one_sided = false)
        : segments(make_chain(points, loop)), links(make_chain_links(points, loop, one_sided)) {}

    std::vector<Manifold> collide(const Shape& shape, const Pose& pose, const Pose& world_from_chain = {}) const {
        std::vector<Manifold> found;
        for (std::size_t i = 0; i < segments.size(); ++i) {
            SimplexCache cache;
            const Manifold manifold =
                collide_link(segments[i], links[i], world_from_chain, shape, pose, kSpeculative, cache);
            if (manifold.point_count > 0) found.push_back(manifold);
        }
        return found;
    }
};

double deepest(const std::vector<Manifold>& manifolds) {
    double depth = 1.0;
    for (const Manifold& manifold : manifolds)
        for (int i = 0; i < manifold.point_count; ++i) depth = std::min<double>(depth, manifold.points[i].separation);
    return depth;
}

const std::vector<Vec2> kFlat = {{4, 0}, {2.5f, 0}, {1, 0}, {0, 0}, {-1, 0}, {-4, 0}};  // its right is up

std::vector<Shape> sliders() {
    return {make_box({1, 0.5f}), make_circle(0.25f), make_capsule({-0.25f, 0}, {0.25f, 0}, 0.25f),
            make_box({1, 0.5f}, 0.1f), make_polygon(std::vector<Vec2>{{-0.5f, -0.25f}, {0.5f, -0.25f}, {0, 0.5f}})};
}

}  // namespace

TEST_CASE("on a flat chain every normal is the chain's, for every shape and depth, also at seams") {
    for (const bool one_sided : {false, true}) {
        const Chain chain(kFlat, false, one_sided);
        int contacts = 0;
        for (const Shape& shape : sliders())
            for (const double depth : {-0.01, 0.0, 0.005, 0.05})
                for (int step = 0; step < 600; ++step) {
                    const Pose pose{{-2.0 + step * 0.00713, 0.25 - depth}, {}};
                    const std::vector<Manifold> found = chain.collide(shape, pose);
                    for (const Manifold& manifold : found) {
                        ++contacts;
                        REQUIRE(manifold.normal.x == 0.0f);
                        REQUIRE(manifold.normal.y == 1.0f);
                    }
                    INFO("x ", pose.position.x, " depth ", depth);
                    REQUIRE(!found.empty());  // the body has a contact at every position
                    REQUIRE(near(deepest(found), -depth, absolute(1e-7)));
                }
        CHECK(contacts > 12000);
    }
}

TEST_CASE("at its end a segment without links pushes sideways, one with links along its own normal") {
    const Shape box = make_box({1, 0.5f}), segment = make_segment({1, 0}, {-1, 0});
    SimplexCache cache;
    // The box overlaps the left end of the segment by 1 mm in x, and the segment is 5 mm above the bottom of the box.
    const Pose pose{{-1.499, 0.245}, {}};
    CHECK(std::abs(collide(segment, {}, box, pose, kSpeculative, cache).normal.x) == 1.0f);
    const ChainLink link{{2, 0}, {-2, 0}, true, true, false};
    cache = {};
    const Manifold linked = collide_link(segment, link, {}, box, pose, kSpeculative, cache);
    CHECK(linked.normal == Vec2{0, 1});
    CHECK(near(linked.points[0].separation, -0.005f, kFloat));
}

TEST_CASE("a one-sided chain is touched from the right of its direction, a two-sided one from both") {
    const Chain one(kFlat, false, true), two(kFlat, false, false);
    const Shape ball = make_circle(0.25f);
    CHECK(one.collide(ball, {{0.5, 0.24}, {}}).size() == 1);
    CHECK(one.collide(ball, {{0.5, -0.24}, {}}).empty());
    CHECK(two.collide(ball, {{0.5, 0.24}, {}}).at(0).normal == Vec2{0, 1});
    CHECK(two.collide(ball, {{0.5, -0.24}, {}}).at(0).normal == Vec2{0, -1});
    // A loop drawn counter-clockwise is solid inside.
    const Chain island({{-2, -1}, {2, -1}, {2, 1}, {-2, 1}}, true, true);
    CHECK(island.collide(ball, {{0, 1.24}, {}}).at(0).normal == Vec2{0, 1});
    CHECK(island.collide(ball, {{0, 0.8}, {}}).empty());
}

TEST_CASE("at a round corner the normal turns from one neighbour's to the other's and no farther") {
    // A hill top at the origin: slopes of 1 to 4 on both sides.
    const Chain hill({{4, -1}, {0, 0}, {-4, -1}}, false, true);
    const Shape ball = make_circle(0.25f);
    const double steepest = std::atan(0.25);
    double last = -1.0;
    for (int step = 0; step <= 200; ++step) {
        const double angle = 1.2 * steepest * (0.01 * step - 1.0);  // of the ball around the top, from the vertical
        const Pose pose{{0.25 * std::sin(angle), 0.25 * std::cos(angle)}, {}};
        const std::vector<Manifold> found = hill.collide(ball, pose);
        REQUIRE(!found.empty());
        for (const Manifold& manifold : found) {
            const double normal = std::atan2(manifold.normal.x, manifold.normal.y);
            REQUIRE(std::abs(normal) <= steepest + 0.001);  // the cone is widened by a thousandth of a radian
            if (std::abs(angle) <= steepest) REQUIRE(near(normal, angle, absolute(1e-7)));
        }
        const double normal = std::atan2(found.at(0).normal.x, found.at(0).normal.y);
        CHECK(normal >= last - 1e-6);
        last = normal;
    }
}

TEST_CASE("in a hollow corner each segment pushes along its own normal alone") {
    // A floor and a wall on its left; the box overlaps both, and the end of the floor is nearer than its surface.
    const Chain corner({{3, 0}, {0, 0}, {0, 3}}, false, true);
    const std::vector<Manifold> found = corner.collide(make_box({1, 1}), {{0.499, 0.49}, {}});
    REQUIRE(found.size() == 2);
    CHECK(found.at(0).normal == Vec2{0, 1});
    CHECK(found.at(1).normal == Vec2{1, 0});
    CHECK(near(deepest({found.at(0)}), -0.01, kFloat));
    CHECK(near(deepest({found.at(1)}), -0.001, kFloat));
}

TEST_CASE("an open end is touched from all around") {
    const Chain wall({{0, 0}, {0, 2}}, false);
    const Shape ball = make_circle(0.25f);
    CHECK(wall.collide(ball, {{0, 2.24}, {}}).at(0).normal == Vec2{0, 1});
    CHECK(wall.collide(ball, {{0, -0.24}, {}}).at(0).normal == Vec2{0, -1});
    CHECK(wall.collide(ball, {{0.24, 1}, {}}).at(0).normal == Vec2{1, 0});
    CHECK(wall.collide(ball, {{-0.24, 1}, {}}).at(0).normal == Vec2{-1, 0});
    CHECK(wall.collide(make_box({4, 0.5f}), {{0.01, 2.24}, {}}).at(0).normal == Vec2{0, 1});  // a plank across the top
}

TEST_CASE("over random hills normals stay in the cone of the neighbours, and shapes on the surface have a contact") {
    using reference::Random;
    int contacts = 0;
    for (std::uint64_t index = 0; index < 300; ++index) {
        Random random(3, index);
        std::vector<Vec2> points;
        for (int i = 0; i < 12; ++i)
            points.push_back(
                {static_cast<float>(6 - i + random.uniform(-0.2, 0.2)), static_cast<float>(random.uniform(0.0, 0.5))});
        const Chain chain(points, false, random.chance(0.5));
        double steepest = 0.0;
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            steepest = std::max(
                steepest, std::abs(double{points[i].y} - points[i + 1].y) / (double{points[i].x} - points[i + 1].x));
        const std::vector<Shape> shapes = sliders();
        const Shape& shape = shapes[index % shapes.size()];
        const Pose world_from_chain{random.point(100.0), make_rotation(random.uniform(-3.0, 3.0))};
        for (int step = 0; step < 20; ++step) {
            // Lowered onto the surface until it has sunk in by a few millimetres.
            Pose local{{random.uniform(-4.0, 4.0), 2.0}, make_rotation(random.uniform(-0.5, 0.5))};
            const auto gap = [&] {
                double nearest = 1e9;
                for (const Shape& segment : chain.segments)
                    nearest = std::min(nearest, distance(segment, {}, shape, local).distance);
                return nearest;
            };
            for (int round = 0; round < 60 && gap() > 0.0; ++round) local.position.y -= std::max(gap(), 1e-4);
            local.position.y -= random.uniform(0.0, 0.004);
            const auto composed = [&](const Pose& pose) {
                const DVec2 position = world_from_chain.position + rotate(world_from_chain.rotation, pose.position);
                return Pose{position, make_rotation(angle(world_from_chain.rotation) + angle(pose.rotation))};
            };
            const std::vector<Manifold> found = chain.collide(shape, composed(local), world_from_chain);
            INFO("hills ", index, " step ", step);
            REQUIRE(!found.empty());
            for (const Manifold& manifold : found) {
                ++contacts;
                const Vec2 normal = inverse_rotate(world_from_chain.rotation, manifold.normal);
                REQUIRE(normal.y > 0.0f);
                REQUIRE(std::abs(normal.x) / normal.y <= steepest + 0.02);
            }
        }
    }
    CHECK(contacts > 6000);
}

TEST_CASE("links contain the points beside each segment") {
    const std::vector<Vec2> points = {{0, 0}, {1, 0}, {2, 1}};
    const std::vector<ChainLink> open = make_chain_links(points, false, true),
                                 closed = make_chain_links(points, true, false);
    REQUIRE(open.size() == 2);
    CHECK(open[0] == ChainLink{{}, {2, 1}, false, true, true});
    CHECK(open[1] == ChainLink{{0, 0}, {}, true, false, true});
    REQUIRE(closed.size() == 3);
    CHECK(closed[0] == ChainLink{{2, 1}, {2, 1}, true, true, false});
    CHECK(closed[2] == ChainLink{{1, 0}, {1, 0}, true, true, false});
    CHECK_THROWS_AS(make_chain_links(std::vector<Vec2>{{0, 0}}, false, false), std::invalid_argument);
}
