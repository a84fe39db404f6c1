// Pairs that touch exactly: dyadic coordinates, quarter turns, and positions that are exact sums.
#include <array>

#include "reference/families/family_lists.hpp"
#include "reference/query/random_shapes.hpp"

namespace tumble::reference {

namespace {

constexpr std::array kQuarterTurns{Rotation{1.0f, 0.0f}, Rotation{0.0f, 1.0f}, Rotation{-1.0f, 0.0f},
                                   Rotation{0.0f, -1.0f}};

Rotation quarter_turn(Random& random) { return kQuarterTurns[static_cast<std::size_t>(random.integer(0, 3))]; }

// Vertices on a grid of 33 x 33 points, times 2^exponent; at least three of them.
Shape grid_polygon(Random& random, int exponent) {
    std::vector<GridPoint> points{{-4, -4}, {5, -3}, {0, 6}};
    const int extra = random.integer(0, 5);
    for (int i = 0; i < extra; ++i) points.push_back({random.integer(-16, 16), random.integer(-16, 16)});
    return Shape::from_raw(to_vertices(convex_hull(std::move(points)), exponent, exponent), 0.0f);
}

PairQuery grid_pair(Random& random, int exponent) {
    return {grid_polygon(random, exponent),
            grid_polygon(random, exponent),
            {std::ldexp(1.0, exponent) * DVec2{double(random.integer(-99, 99)), double(random.integer(-99, 99))},
             quarter_turn(random)},
            {{}, quarter_turn(random)}};
}

struct GridEdge {
    DVec2 from, to;
};

GridEdge grid_edge(const Shape& shape, Rotation q, int i) {
    const int next = i + 1 == shape.vertex_count() ? 0 : i + 1;
    return {rotate(q, DVec2(shape.vertex(i))), rotate(q, DVec2(shape.vertex(next)))};
}

PairQuery make_touching_vertices(Random& random) {
    PairQuery query = grid_pair(random, random.integer(-20, 4));
    // A steep direction with odd components is normal to no edge of the grid: one vertex of each shape is extreme.
    const double across = random.sign(), up = random.sign();
    const DVec2 normal{across * (37.0 + 2.0 * random.integer(0, 99)), up * 331.0};
    query.pose_b.position = query.pose_a.position + (support_point(query.a, query.pose_a.rotation, normal) -
                                                     support_point(query.b, query.pose_b.rotation, -normal));
    return query;
}

PairQuery make_touching_vertex_edge(Random& random) {
    PairQuery query = grid_pair(random, random.integer(-20, 4));
    const GridEdge edge = grid_edge(query.a, query.pose_a.rotation, random.integer(0, query.a.vertex_count() - 1));
    const DVec2 outward = -perp(edge.to - edge.from);
    const DVec2 touched = edge.from + random.integer(0, 16) / 16.0 * (edge.to - edge.from);
    query.pose_b.position = query.pose_a.position + (touched - support_point(query.b, query.pose_b.rotation, -outward));
    if (random.chance(0.5)) query = query.swapped();
    return query;
}

PairQuery make_touching_edges(Random& random) {
    PairQuery query = grid_pair(random, random.integer(-20, 4));
    query.b = query.a;
    query.pose_b.rotation = {-query.pose_a.rotation.c, -query.pose_a.rotation.s};
    const GridEdge edge = grid_edge(query.a, query.pose_a.rotation, random.integer(0, query.a.vertex_count() - 1));
    query.pose_b.position =
        query.pose_a.position + (2.0 * edge.from + random.integer(0, 32) / 16.0 * (edge.to - edge.from));
    return query;
}

// The origin exactly on a difference of two vertices, or half way between two such differences.
PairQuery make_origin_on_simplex(Random& random) {
    PairQuery query = grid_pair(random, random.integer(-20, 4));
    const auto difference = [&] {
        const int i = random.integer(0, query.a.vertex_count() - 1), j = random.integer(0, query.b.vertex_count() - 1);
        return rotate(query.pose_a.rotation, DVec2(query.a.vertex(i))) -
               rotate(query.pose_b.rotation, DVec2(query.b.vertex(j)));
    };
    const DVec2 first = difference(), second = random.chance(0.3) ? first : difference();
    query.pose_b.position = query.pose_a.position + 0.5 * (first + second);
    return query;
}

constexpr std::array kTouchingFamilies{
    PairFamily{"touching_vertices", "two vertices that touch exactly", seeded<make_touching_vertices>},
    PairFamily{"touching_vertex_edge", "a vertex exactly on an edge", seeded<make_touching_vertex_edge>},
    PairFamily{"touching_edges", "edges exactly on each other", seeded<make_touching_edges>},
    PairFamily{"origin_on_simplex", "the origin on a vertex or an edge between vertices of the Minkowski difference",
               seeded<make_origin_on_simplex>},
};

}  // namespace

std::span<const PairFamily> touching_families() { return kTouchingFamilies; }

}  // namespace tumble::reference
