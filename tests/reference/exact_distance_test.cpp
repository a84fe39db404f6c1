// The exact oracle against hand-worked cases, and against a second method in long double: the signed distance of the
// origin from the hull of all vertex differences.
#include "reference/exact/exact_distance.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "reference/query/random_shapes.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::reference;
using namespace tumble::test;

namespace {

Shape point_shape(float radius = 0.0f) { return Shape::from_raw(std::array{Vec2{}}, radius); }

Shape segment(Vec2 from, Vec2 to, float radius = 0.0f) { return Shape::from_raw(std::array{from, to}, radius); }

Pose at(double x, double y, Rotation q = {}) { return {{x, y}, q}; }

// exact == x, decided without rounding
void check_equal(const PairQuery& query, double x) {
    CAPTURE(to_hex(query));
    CHECK(ExactDistance(query).compare(x) == 0);
    CHECK(ExactDistance(query).value() == x);
    CHECK(ExactDistance(query.swapped()).compare(x) == 0);
}

struct LongPoint {
    long double x = 0.0L, y = 0.0L;
};

long double cross(LongPoint o, LongPoint p, LongPoint q) {
    return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
}

LongPoint to_world(const Pose& pose, DVec2 origin, Vec2 v) {
    const long double c = pose.rotation.c, s = pose.rotation.s, x = v.x, y = v.y;
    return {c * x - s * y + (static_cast<long double>(pose.position.x) - origin.x),
            s * x + c * y + (static_cast<long double>(pose.position.y) - origin.y)};
}

std::vector<LongPoint> difference_hull(const PairQuery& query) {
    std::vector<LongPoint> points;
    for (int i = 0; i < query.a.vertex_count(); ++i) {
        for (int j = 0; j < query.b.vertex_count(); ++j) {
            const LongPoint a = to_world(query.pose_a, query.pose_a.position, query.a.vertex(i));
            const LongPoint b = to_world(query.pose_b, query.pose_a.position, query.b.vertex(j));
            points.push_back({a.x - b.x, a.y - b.y});
        }
    }
    std::ranges::sort(points, [](LongPoint p, LongPoint q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
    std::vector<LongPoint> hull;
    for (const bool upwards : {true, false}) {
        const std::size_t start = hull.size();
        for (const LongPoint p : points) {
            while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0.0L) hull.pop_back();
            hull.push_back(p);
        }
        if (upwards || hull.size() > start + 1) hull.pop_back();
        std::ranges::reverse(points);
    }
    return hull;
}

// Also for a hull of one or two points: the two edges of a segment run out and back.
long double signed_distance_of_origin(const std::vector<LongPoint>& hull) {
    long double outside_sq = INFINITY, inside = -INFINITY;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const LongPoint p = hull[i], q = hull[(i + 1) % hull.size()], edge{q.x - p.x, q.y - p.y};
        const long double length_sq = edge.x * edge.x + edge.y * edge.y;
        const long double t =
            length_sq > 0.0L ? std::clamp(-(p.x * edge.x + p.y * edge.y) / length_sq, 0.0L, 1.0L) : 0.0L;
        const LongPoint near{p.x + t * edge.x, p.y + t * edge.y};
        outside_sq = std::min(outside_sq, near.x * near.x + near.y * near.y);
        if (length_sq > 0.0L) inside = std::max(inside, cross(p, {}, q) / std::sqrt(length_sq));
    }
    return inside > -INFINITY && inside < 0.0L ? inside : std::sqrt(outside_sq);
}

PairQuery random_query(Random& random) {
    PairQuery query{random_shape(random, 0),
                    random_shape(random, 0),
                    at(0.0, 0.0, random.rotation()),
                    {random.point(2.0), random.rotation()}};
    if (random.chance(0.2)) query.a = random_polygon(random, 20, 0);
    if (random.chance(0.2)) place_vertex_to_edge(query, random, random.signed_magnitude(-40, 0));
    return query;
}

}  // namespace

TEST_CASE("separated shapes have the hand-worked distance") {
    // Corner (1, 1) against corner (4, 5): 3-4-5.
    check_equal({box(1.0, 1.0), box(1.0, 1.0), at(0.0, 0.0), at(5.0, 6.0)}, 5.0);
    // Faces 1 apart; radii 1/4 and 1/8 off that.
    check_equal({box(1.0, 1.0), box(0.5, 2.0), at(-7.0, 0.0), at(-4.5, 0.5)}, 1.0);
    check_equal({box(1.0, 1.0, 0.25), box(0.5, 2.0, 0.125), at(-7.0, 0.0), at(-4.5, 0.5)}, 0.625);
    // The line x + y = 2 through a rotation taken literally, (c, s) = (3, 4): the point (1, 0) becomes (3, 4).
    const ExactDistance turned({segment({2.0f, 0.0f}, {0.0f, 2.0f}), segment({1.0f, 0.0f}, {1.0f, 0.0f}), at(0.0, 0.0),
                                at(-3.0, -4.0, {3.0f, 4.0f})});
    CHECK(turned.value() == std::sqrt(2.0));
    check_equal({point_shape(), point_shape(), at(1.0, 1.0), at(1.0, 1.0 + 0x1p-52)}, 0x1p-52);
}

TEST_CASE("overlapping shapes have the hand-worked depth") {
    check_equal({box(1.0, 1.0), box(1.0, 1.0), at(0.0, 0.0), at(1.75, 0.5)}, -0.25);
    check_equal({box(1.0, 1.0, 0.25), box(1.0, 1.0), at(0.0, 0.0), at(1.75, 0.5)}, -0.5);
    // Concentric: the least depth is vertical, 1 + 1/4.
    check_equal({box(3.0, 1.0), box(0.25, 0.25), at(0.0, 0.0), at(0.0, 0.0)}, -1.25);
    // Crossing segments: the difference is the square [-1, 1]^2 about (-1/4, -1/2).
    check_equal(
        {segment({-1.0f, 0.0f}, {1.0f, 0.0f}), segment({0.0f, -1.0f}, {0.0f, 1.0f}), at(0.0, 0.0), at(0.25, 0.5)},
        -0.5);
    // Rotated by a quarter turn about the origin of B: the corner (2, -1) of B becomes (1, 2).
    check_equal({box(1.0, 1.0), box(2.0, 1.0), at(0.0, 0.0), at(0.0, 2.5, {0.0f, 1.0f})}, -0.5);
}

TEST_CASE("touching and flat shapes have the hand-worked distance") {
    check_equal({box(1.0, 1.0), box(1.0, 1.0), at(0.0, 0.0), at(2.0, 2.0)}, 0.0);
    check_equal({box(1.0, 1.0), box(1.0, 1.0), at(0.0, 0.0), at(2.0, 0.3)}, 0.0);
    check_equal({point_shape(0.5f), point_shape(0.25f), at(9.0, 9.0), at(9.0, 9.0)}, -0.75);
    // On one line: apart by 1, end to end, and inside each other.
    const Shape bar = segment({-1.0f, -1.0f}, {1.0f, 1.0f});
    CHECK(ExactDistance({bar, bar, at(0.0, 0.0), at(2.5, 2.5)}).value() == std::sqrt(0.5));
    check_equal({bar, bar, at(0.0, 0.0), at(2.0, 2.0)}, 0.0);
    check_equal({bar, bar, at(0.0, 0.0), at(0.5, 0.5)}, 0.0);
    check_equal({bar, point_shape(1.0f), at(0.0, 0.0), at(0.5, 0.5)}, -1.0);
}

TEST_CASE("an irrational distance is compared without rounding") {
    const ExactDistance diagonal({point_shape(), point_shape(), at(0.0, 0.0), at(1.0, 1.0)});  // sqrt(2)
    const double rounded = std::sqrt(2.0);                                                     // a little above it
    CHECK(diagonal.value() == rounded);
    CHECK(diagonal.compare(rounded) == -1);
    CHECK(diagonal.compare(std::nextafter(rounded, 0.0)) == 1);
    CHECK(near(diagonal.minus(rounded), -9.667293313452913e-17, kDouble));
    CHECK(diagonal.minus(-rounded) == 2.0 * rounded);
}

TEST_CASE("the oracle is exact over the range of float and double") {
    check_equal({point_shape(), point_shape(), at(0.0, 0.0), at(0x1p-1074, 0.0)}, 0x1p-1074);
    check_equal({point_shape(), point_shape(), at(-0x1p1000, 0.0), at(0x1p1000, 0.0)}, 0x1p1001);
    const float tiny = 0x1p-149f;
    check_equal({point_shape(tiny), segment({4.0f * tiny, 1.0f}, {4.0f * tiny, -1.0f}), at(0.0, 0.0), at(0.0, 0.0)},
                3.0 * tiny);
    // 2^100 apart with a radius of 2^-100: the radius is not lost.
    const ExactDistance far({point_shape(0x1p-100f), point_shape(), at(0.0, 0.0), at(0x1p100, 0.0)});
    CHECK(far.compare(0x1p100) == -1);
    CHECK(far.minus(0x1p100) == -0x1p-100);
}

TEST_CASE("a closest pair is unique unless parallel edges face each other") {
    const Shape square = box(1.0, 1.0);
    CHECK(ExactDistance({square, square, at(0.0, 0.0), at(5.0, 6.0)}).has_unique_pair());
    CHECK_FALSE(ExactDistance({square, square, at(0.0, 0.0), at(5.0, 0.5)}).has_unique_pair());
    CHECK(ExactDistance({square, square, at(0.0, 0.0), at(5.0, 0.5, make_rotation(0.5))}).has_unique_pair());
    CHECK(ExactDistance({square, point_shape(), at(0.0, 0.0), at(5.0, 0.5)}).has_unique_pair());
    CHECK_FALSE(ExactDistance({square, square, at(0.0, 0.0), at(0.5, 0.5)}).has_unique_pair());
}

TEST_CASE("the oracle agrees with the hull of differences in long double") {
    int overlapping = 0;
    long double worst = 0.0L;
    constexpr int kPairs = 20000;
    for (std::uint64_t index = 0; index < kPairs; ++index) {
        Random random(11, index);
        const PairQuery query = random_query(random);
        const ExactDistance exact(query);
        const long double core = signed_distance_of_origin(difference_hull(query));
        const long double other = core - query.a.radius() - query.b.radius();
        const long double error = std::abs(other - static_cast<long double>(exact.value())) -
                                  std::abs(0x1p-53L * exact.value());  // the rounding of value() itself
        worst = std::max(worst, error / (0x1p-63L * (error_scale(query) + query.a.radius() + query.b.radius())));
        overlapping += exact.sign() < 0;
    }
    CHECK(overlapping > kPairs * 3 / 10);
    CHECK(overlapping < kPairs * 7 / 10);
    // Per coordinate of a difference 3 roundings of at most half a unit of the scale, and 2 of the distance itself.
    CHECK(worst < 4.0L);
    MESSAGE("largest difference " << static_cast<double>(worst) << " units of 2^-63 (RA + RB + |p| + radii)");
}
