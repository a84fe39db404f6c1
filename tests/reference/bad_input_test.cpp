// Outlines that Shape::from_raw() accepts and no factory makes: clockwise, self-crossing, repeated and random. The
// answer may be wrong, but it has a status, is finite, and needs a bounded number of iterations.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "reference/query/random_shapes.hpp"
#include "tumble/distance.hpp"

using namespace tumble;
using namespace tumble::reference;

namespace {

// The cap of the GJK loop for n vertices in all, 32 + 4 ceil(log2(n / 8)), and the first support.
int iteration_limit(int vertices) {
    return 33 + 4 * std::max(0, static_cast<int>(std::ceil(std::log2(vertices / 8.0))));
}

void check_decided(const PairQuery& q) {
    SimplexCache cache;
    for (int again = 0; again < 3; ++again) {
        const DistanceResult answer = distance(q.a, q.pose_a, q.b, q.pose_b, &cache);
        CHECK(answer.status != DistanceStatus::invalid);
        for (const double number : {answer.distance, answer.lower, answer.upper, answer.point_a.x, answer.point_a.y,
                                    answer.point_b.x, answer.point_b.y, answer.normal.x, answer.normal.y})
            CHECK(std::isfinite(number));
        CHECK(int{answer.iterations} <= iteration_limit(q.a.vertex_count() + q.b.vertex_count()));
        CHECK((answer.status == DistanceStatus::separated) == (answer.lower > 0.0));
        CHECK((answer.status == DistanceStatus::overlapping) == (answer.upper < 0.0));
    }
}

Shape reversed(const Shape& shape) {
    std::vector<Vec2> vertices;
    for (int i = shape.vertex_count(); i-- > 0;) vertices.push_back(shape.vertex(i));
    return Shape::from_raw(vertices, shape.radius());
}

Shape scattered(Random& random) {
    std::vector<Vec2> vertices;
    const int count = random.integer(1, 40);
    for (int i = 0; i < count; ++i)
        vertices.push_back(i > 0 && random.chance(0.2) ? vertices.back() : to_float(random.point(1.0)));
    return Shape::from_raw(vertices, random.chance(0.3) ? 0.1f : 0.0f);
}

}  // namespace

TEST_CASE("separated clockwise outlines have the distance of their counter-clockwise twins") {
    int separated = 0;
    for (std::uint64_t index = 0; index < 2000; ++index) {
        Random random(5, index);
        const PairQuery query{random_polygon(random, 8, 0),
                              random_polygon(random, 8, 0),
                              {{}, random.rotation()},
                              {random.point(2.5), random.rotation()}};
        PairQuery clockwise = query;
        clockwise.a = reversed(query.a);
        CAPTURE(index);
        check_decided(clockwise);
        const DistanceResult answer = distance(query.a, query.pose_a, query.b, query.pose_b);
        if (answer.status != DistanceStatus::separated) continue;
        ++separated;  // support vertices do not depend on the order
        const DistanceResult same = distance(clockwise.a, clockwise.pose_a, clockwise.b, clockwise.pose_b);
        CHECK(same.status == DistanceStatus::separated);
        CHECK(std::abs(same.distance - answer.distance) <= 32.0 * error_unit(query));
    }
    CHECK(separated > 600);
}

TEST_CASE("a bow tie, a star and a needle give a valid answer") {
    const std::array<Vec2, 4> bow_tie{{{-1, -1}, {1, 1}, {1, -1}, {-1, 1}}};
    const std::array<Vec2, 5> star{{{0, 1}, {0.6f, -0.8f}, {-1, 0.3f}, {1, 0.3f}, {-0.6f, -0.8f}}};
    const std::array<Vec2, 6> needle{{{0, 0}, {1, 0}, {2, 0}, {1, 0}, {0, 0}, {0, 0}}};
    const std::array shapes{Shape::from_raw(bow_tie, 0.0f), Shape::from_raw(star, 0.0f),
                            Shape::from_raw(needle, 0.25f)};
    for (const Shape& a : shapes)
        for (const Shape& b : shapes)
            for (const double x : {0.0, 0.5, 1.0, 2.0, 3.0}) check_decided({a, b, {}, {{x, 0.25 * x}, {}}});
}

TEST_CASE("random points as an outline give a valid answer") {
    for (std::uint64_t index = 0; index < 5000; ++index) {
        Random random(6, index);
        const PairQuery query{scattered(random),
                              scattered(random),
                              {random.point(1.0), random.rotation()},
                              {random.point(2.0), random.rotation()}};
        CAPTURE(index);
        check_decided(query);
    }
}
