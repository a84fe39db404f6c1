// The distance subalgorithms by themselves: one simplex, reduced.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "narrow/gjk/johnson.hpp"
#include "narrow/gjk/signed_volumes.hpp"
#include "narrow/gjk/voronoi.hpp"
#include "support/near.hpp"
#include "support/random_pairs.hpp"

using namespace tumble;
using namespace tumble::test;
using namespace tumble_test;

namespace {

// The simplex of A's first vertices against the one vertex of B.
Simplex simplex_of(const CorePair& pair, int count) {
    Simplex simplex;
    for (int i = 0; i < count; ++i)
        simplex.vertices[i] = minkowski_vertex(pair, {static_cast<std::uint16_t>(i), std::uint16_t{0}});
    simplex.count = count;
    return simplex;
}

double segment_distance_sq(DVec2 from, DVec2 to) {
    const DVec2 edge = to - from;
    const double t = std::clamp(-dot(from, edge) / length_sq(edge), 0.0, 1.0);
    return length_sq(from + t * edge);
}

double brute_distance_sq(const Simplex& simplex) {
    const MinkowskiVertex(&v)[3] = simplex.vertices;
    if (simplex.count == 2) return segment_distance_sq(v[0].w, v[1].w);
    const double sides[3] = {cross(v[0].w, v[1].w), cross(v[1].w, v[2].w), cross(v[2].w, v[0].w)};
    const auto [low, high] = std::minmax({sides[0], sides[1], sides[2]});
    if (low > 0.0 || high < 0.0) return 0.0;
    return std::min({segment_distance_sq(v[0].w, v[1].w), segment_distance_sq(v[1].w, v[2].w),
                     segment_distance_sq(v[2].w, v[0].w)});
}

struct Outcomes {
    int vertex = 0, edge = 0, inside = 0;
};

template <typename Reducer>
Outcomes check_reducer() {
    PairSource source(71);
    Outcomes outcomes;
    for (int sample = 0; sample < 10000; ++sample) {
        std::array<Vec2, 3> vertices;
        for (Vec2& vertex : vertices) {
            const double x = source.uniform(-1, 1), y = source.uniform(-1, 1);
            vertex = to_float(DVec2{x, y});
        }
        const int count = sample % 4 == 0 ? 2 : 3;
        const Shape a = Shape::from_raw(vertices, 0), point = make_circle(0);
        const Pose at = source.pose(0.5);
        const CorePair pair = make_core_pair(a, source.pose(0.1), point, at);
        const Simplex whole = simplex_of(pair, count);
        Simplex reduced = whole;
        const Closest closest = Reducer::reduce(pair, reduced);
        const double expected = brute_distance_sq(whole);
        // Squares of lengths of about 1: a few roundings, and the lever of thin triangles.
        CHECK(std::abs(closest.distance_sq - expected) <= 1e-12);
        CHECK(closest.contains_origin == (expected == 0.0));
        if (closest.contains_origin) {
            ++outcomes.inside;
            continue;
        }
        // The direction leads from the nearest point to the origin, and the subset holds that point.
        const DVec2 nearest = (-closest.toward / length_sq(closest.direction)) * closest.direction;
        CHECK(near(length_sq(nearest), expected, absolute(1e-14)));
        REQUIRE(reduced.count >= 1);
        REQUIRE(reduced.count <= 2);
        const DVec2 first = reduced.vertices[0].w, last = reduced.vertices[reduced.count - 1].w;
        CHECK(near((reduced.count == 1 ? length_sq(first) : segment_distance_sq(first, last)), expected,
                   absolute(1e-14)));
        ++(reduced.count == 1 ? outcomes.vertex : outcomes.edge);
    }
    return outcomes;
}

}  // namespace

TEST_CASE("Voronoi regions, Johnson's cofactors and signed volumes find the nearest point and its subset") {
    const Outcomes voronoi = check_reducer<VoronoiRegions>(), johnson = check_reducer<Johnson>(),
                   volumes = check_reducer<SignedVolumes>();
    CHECK(voronoi.vertex > 1500);
    CHECK(voronoi.edge > 1500);
    CHECK(voronoi.inside > 500);
    CHECK(johnson.vertex == voronoi.vertex);
    CHECK(johnson.inside == voronoi.inside);
    CHECK(volumes.vertex == voronoi.vertex);
    CHECK(volumes.inside == voronoi.inside);
}

TEST_CASE("scales whose fourth powers overflow or vanish reduce alike") {
    for (const float scale : {0x1p-100f, 1.0f, 0x1p100f}) {
        // A triangle around the origin, one with the origin beyond an edge, one beyond a vertex.
        const std::array<Vec2, 3> around = {{{-1, -1}, {2, -1}, {0, 2}}}, beyond = {{{-1, 1}, {2, 1}, {0, 3}}},
                                  past = {{{1, 1}, {3, 1}, {1, 3}}};
        for (const auto& [vertices, count] : {std::pair{around, 3}, std::pair{beyond, 2}, std::pair{past, 1}}) {
            std::array<Vec2, 3> scaled;
            std::ranges::transform(vertices, scaled.begin(), [scale](Vec2 v) { return scale * v; });
            const Shape a = Shape::from_raw(scaled, 0), point = make_circle(0);
            const CorePair pair = make_core_pair(a, {}, point, {});
            const auto check = [&, expected = count](auto reducer) {
                Simplex simplex = simplex_of(pair, 3);
                const Closest closest = decltype(reducer)::reduce(pair, simplex);
                CHECK(closest.contains_origin == (expected == 3));
                CHECK(simplex.count == expected);
            };
            check(VoronoiRegions{});
            check(Johnson{});
            check(SignedVolumes{});
        }
    }
}
