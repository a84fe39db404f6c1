// Pairs at a given tiny gap or depth, by each kind of feature, and edges that are parallel or almost so.
#include <array>

#include "reference/families/family_lists.hpp"
#include "reference/query/random_shapes.hpp"

namespace tumble::reference {

namespace {

PairQuery make_pair(Random& random, int exponent) {
    return {random_shape(random, exponent),
            random_shape(random, exponent),
            {random.point(4.0), random.rotation()},
            {{}, random.rotation()}};
}

void place_by_random_features(PairQuery& query, Random& random, double gap) {
    switch (random.integer(0, 2)) {
        case 0: return place_vertex_to_vertex(query, random, gap);
        case 1: return place_vertex_to_edge(query, random, gap);
        default: return place_edge_to_edge(query, random, gap);
    }
}

double small_length(Random& random) { return random.magnitude(-40, -7); }

PairQuery make_near_gap(Random& random) {
    PairQuery query = make_pair(random, 0);
    place_by_random_features(query, random, small_length(random));
    return query;
}

PairQuery make_near_overlap(Random& random) {
    PairQuery query = make_pair(random, 0);
    place_by_random_features(query, random, -small_length(random));
    return query;
}

// B is A rotated by exactly half a turn about its origin, so that each edge of A faces a parallel edge of B.
PairQuery make_parallel_edges(Random& random) {
    PairQuery query;
    query.a = query.b = random.chance(0.5) ? random_box(random, 0) : random_polygon(random, 8, 0);
    query.pose_a = {random.point(4.0), random.chance(0.3) ? Rotation{} : random.rotation()};
    query.pose_b.rotation = {-query.pose_a.rotation.c, -query.pose_a.rotation.s};
    const int count = query.a.vertex_count();
    const int i = random.integer(0, count - 1);
    const DVec2 from = rotate(query.pose_a.rotation, DVec2(query.a.vertex(i)));
    const DVec2 edge = rotate(query.pose_a.rotation, DVec2(query.a.vertex(i + 1 == count ? 0 : i + 1))) - from;
    const double side = length(edge);
    const double gap = random.chance(0.2) ? 0.0 : random.signed_magnitude(-40, 0);
    // The edge of B runs from -from to -(from + edge). It is moved onto A's edge, then along it and off it.
    query.pose_b.position = query.pose_a.position + 2.0 * from + random.uniform(0.05, 1.95) * edge -
                            (gap / (side > 0.0 ? side : 1.0)) * perp(edge);
    return query;
}

PairQuery make_almost_parallel(Random& random) {
    PairQuery query{random_box(random, 0),
                    random.chance(0.5) ? random_box(random, 0) : random_polygon(random, 8, 0),
                    {random.point(4.0), {}},
                    {}};
    const double gap = random.magnitude(-30, -1), angle = random.signed_magnitude(-27, -7);
    if (random.chance(0.5)) {
        // The rotation (1, s) itself: make_rotation() would round so small an angle.
        query.b = query.a;
        query.pose_b.rotation = {1.0f, static_cast<float>(angle)};
        const double height = 2.0 * query.a.vertex(2).y;
        query.pose_b.position = query.pose_a.position + DVec2{random.uniform(-1.0, 1.0), height + gap};
    } else {
        query.pose_a.rotation = random.rotation();
        place_edge_to_edge(query, random, gap, angle);
    }
    return query;
}

constexpr std::array kGapFamilies{
    PairFamily{"near_gap", "1 m shapes 1e-12 to 1e-2 m apart, by vertices and edges", seeded<make_near_gap>},
    PairFamily{"near_overlap", "1 m shapes 1e-12 to 1e-2 m deep", seeded<make_near_overlap>},
    PairFamily{"parallel_edges", "edges exactly parallel, touching, apart or overlapping", seeded<make_parallel_edges>},
    PairFamily{"almost_parallel", "edges 1e-8 to 1e-2 rad from parallel", seeded<make_almost_parallel>},
};

}  // namespace

std::span<const PairFamily> gap_families() { return kGapFamilies; }

}  // namespace tumble::reference
