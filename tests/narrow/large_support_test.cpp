// Supports of large polygons by the directions of their edges against those over all vertices.
#include "narrow/cores/large_support.hpp"

#include <doctest/doctest.h>

#include <array>

#include "narrow/cores/error_bound.hpp"
#include "narrow/faces/faces.hpp"
#include "support/random_pairs.hpp"

using namespace tumble;
using namespace tumble_test;

namespace {

double highest(const Shape& shape, DVec2 direction) {
    double best = -1e300;
    for (int i = 0; i < shape.vertex_count(); ++i) best = std::max(best, dot(direction, DVec2(shape.vertex(i))));
    return best;
}

void check_supports(const Shape& shape, PairSource& source, int directions) {
    REQUIRE(shape.large() != nullptr);
    REQUIRE_FALSE(shape.large()->edge_angles.empty());
    // Edges shorter than rounding hide 2 u of the perimeter.
    const double rounding = 16.0 * 0x1p-53 * shape.core_radius();
    for (int sample = 0; sample < directions; ++sample) {
        DVec2 direction(source.uniform(-1, 1), source.uniform(-1, 1));
        if (sample % 4 == 0) direction.x = 0.0;
        if (sample % 4 == 1) {  // across an edge, whose ends are equally high
            const int from = source.below(shape.vertex_count());
            direction = -perp(DVec2(shape.vertex((from + 1) % shape.vertex_count())) - DVec2(shape.vertex(from)));
        }
        const int near = source.below(shape.vertex_count()), found = large_support(*shape.large(), direction, near);
        CHECK(large_support(*shape.large(), direction, found) == found);
        REQUIRE(found >= 0);
        REQUIRE(found < shape.vertex_count());
        CHECK(dot(direction, DVec2(shape.vertex(found))) >= highest(shape, direction) - rounding * length(direction));
    }
}

}  // namespace

TEST_CASE("the support found by bisection is the highest vertex of round, flat and huge polygons") {
    PairSource source(95);
    for (const int count : {9, 10, 17, 100, 1000}) {
        check_supports(source.ellipse(count, 1, 1), source, 2000);
        check_supports(source.ellipse(count, 1, 0.01), source, 2000);
        check_supports(source.ellipse(count, 0.001, 1), source, 2000);
        check_supports(source.ellipse(count, 1e6, 1e6), source, 500);
    }
    check_supports(source.ellipse(60000, 1, 1), source, 200);
}

TEST_CASE("the support does not depend on the vertex at which the search starts") {
    PairSource source(97);
    for (const Shape& shape : {source.ellipse(10, 1, 1), source.ellipse(1000, 1, 1), source.ellipse(300, 1, 0.001)}) {
        for (int sample = 0; sample < 2000; ++sample) {
            const DVec2 direction(source.uniform(-1, 1), source.uniform(-1, 1));
            const int count = shape.vertex_count(), found = large_support(*shape.large(), direction, 0);
            for (const int aside : {-6, -1, 0, 1, 3, 4, 5, 7}) {
                const int near = (found + aside + count) % count;
                CHECK(large_support(*shape.large(), direction, near) == found);
            }
        }
    }
}

TEST_CASE("the deepest face of large overlapping polygons is the deepest in a loop over all faces") {
    PairSource source(98);
    for (int sample = 0; sample < 300; ++sample) {
        const int count = 9 + source.below(120);
        const Shape a = source.ellipse(count, 1, source.uniform(0.01, 1.0));
        const Shape b =
            sample % 3 ? source.ellipse(9 + source.below(120), 0.5, 0.3) : make_segment({-0.4f, 0.1f}, {0.5f, 0.2f});
        const Pose pose_a = source.pose(0.2), pose_b = source.pose(0.2);
        const CorePair pair = make_core_pair(a, pose_a, b, pose_b);
        double deepest = -1e300;
        for (int edge = 0; edge < a.vertex_count(); ++edge)
            deepest = std::max(deepest, face_of_a(pair, edge).face.separation);
        for (int edge = 0; edge < b.vertex_count(); ++edge)
            deepest = std::max(deepest, face_of_b(pair, edge).face.separation);
        // Supports of equal height may be another vertex, whose height rounds otherwise.
        CHECK(std::abs(deepest_face(pair).face.separation - deepest) <= error_bound(pair));
    }
}

TEST_CASE("outlines that bisection cannot search are detected by their turns") {
    const auto has_angles = [](const std::vector<Vec2>& points) {
        return !Shape::from_raw(points, 0).large()->edge_angles.empty();
    };
    std::vector<Vec2> points;
    for (int i = 0; i < 12; ++i) {
        const SinCos at = sin_cos(i * kPi / 6.0);
        points.push_back({static_cast<float>(at.cos), static_cast<float>(at.sin)});
    }
    CHECK(has_angles(points));
    CHECK_FALSE(has_angles({points.rbegin(), points.rend()}));  // clockwise
    std::vector<Vec2> doubled = points;
    doubled[3] = doubled[4];
    CHECK_FALSE(has_angles(doubled));
    std::vector<Vec2> twice_round = points;
    twice_round.insert(twice_round.end(), points.begin(), points.end());
    CHECK_FALSE(has_angles(twice_round));
    std::vector<Vec2> star;
    for (int i = 0; i < 12; ++i) star.push_back(points[static_cast<std::size_t>(i * 5 % 12)]);
    CHECK_FALSE(has_angles(star));
}

TEST_CASE("a search in a direction of zero or NaN ends with a valid vertex") {
    PairSource source(96);
    const Shape shape = source.ellipse(200, 1, 0.5);
    for (const DVec2 direction : {DVec2{0, 0}, DVec2{std::nan(""), 1}, DVec2{1e308, -1e308}, DVec2{5e-324, 0}}) {
        const int near = source.below(shape.vertex_count()), found = large_support(*shape.large(), direction, near);
        CHECK(large_support(*shape.large(), direction, found) == found);
        CHECK(found >= 0);
        CHECK(found < 200);
    }
}
