// Cores thinner than the rounding of their coordinates, and cores of lower dimension than their vertex count suggests.
#include <array>
#include <cmath>

#include "reference/families/family_lists.hpp"
#include "reference/query/random_shapes.hpp"

namespace tumble::reference {

namespace {

struct Shapes {
    Shape a, b;
};

PairQuery pair_of(Random& random, Shapes shapes, double reach) {
    const DVec2 origin = random.point(4.0);
    return {std::move(shapes.a),
            std::move(shapes.b),
            {origin, random.rotation()},
            {origin + random.point(reach), random.rotation()}};
}

Shape sliver() { return box(5.0, 0.5e-7); }

PairQuery make_slivers(Random& random) {
    PairQuery query = pair_of(random, {sliver(), random.chance(0.5) ? sliver() : random_shape(random, 0)}, 8.0);
    if (random.chance(0.4)) place_vertex_to_edge(query, random, random.magnitude(-40, -7));
    return query;
}

PairQuery make_crossed_slivers(Random& random) {
    PairQuery query = pair_of(random, {sliver(), sliver()}, 2.0);
    if (random.chance(0.3)) {  // almost parallel
        query.pose_a.rotation = {1.0f, 0.0f};
        query.pose_b.rotation = {1.0f, static_cast<float>(random.signed_magnitude(-30, -10))};
        query.pose_b.position = query.pose_a.position + DVec2{random.uniform(-1.0, 1.0), random.uniform(-1e-7, 1e-7)};
    }
    return query;
}

// An exactly convex square whose upper right corner is cut by an edge of one ulp.
Shape ulp_cornered_square(Random& random) {
    const auto h = static_cast<float>(random.magnitude(-2, 0));
    const float below = std::nextafterf(h, 0.0f);
    const std::array<Vec2, 5> vertices{{{-h, -h}, {h, -h}, {h, below}, {below, h}, {-h, h}}};
    return Shape::from_raw(vertices, 0.0f);
}

PairQuery make_ulp_edges(Random& random) {
    PairQuery query = pair_of(
        random,
        {ulp_cornered_square(random), random.chance(0.5) ? ulp_cornered_square(random) : random_shape(random, 0)}, 2.0);
    if (random.chance(0.6)) {
        const DVec2 corner = rotate(query.pose_a.rotation, DVec2{std::sqrt(0.5), std::sqrt(0.5)});
        place_vertex_to_vertex(query, corner, random.signed_magnitude(-40, 0));
    }
    return query;
}

// The shape with vertices repeated at random, up to eight in all.
Shape with_duplicates(Random& random, const Shape& shape) {
    std::vector<Vec2> vertices;
    int spare = Shape::kInlineVertices - shape.vertex_count();
    for (int i = 0; i < shape.vertex_count(); ++i) {
        vertices.push_back(shape.vertex(i));
        for (; spare > 0 && random.chance(0.5); --spare) vertices.push_back(shape.vertex(i));
    }
    return Shape::from_raw(vertices, shape.radius());
}

PairQuery make_duplicate_vertices(Random& random) {
    PairQuery query = pair_of(
        random,
        {with_duplicates(random, random_polygon(random, 5, 0)), with_duplicates(random, random_shape(random, 0))}, 3.0);
    if (random.chance(0.4)) place_vertex_to_vertex(query, random, random.signed_magnitude(-40, -7));
    return query;
}

// A polygon with the exact middle of each edge among its vertices.
Shape with_midpoints(Random& random) {
    std::vector<GridPoint> corners;
    for (int i = 0; i < 4; ++i)
        corners.push_back(
            {std::int64_t{2} * random.integer(-1000000, 1000000), std::int64_t{2} * random.integer(-1000000, 1000000)});
    corners = convex_hull(std::move(corners));
    std::vector<GridPoint> points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const GridPoint from = corners[i], to = corners[(i + 1) % corners.size()];
        points.push_back(from);
        points.push_back({(from.x + to.x) / 2, (from.y + to.y) / 2});
    }
    return Shape::from_raw(to_vertices(points, -21, -21), 0.0f);
}

PairQuery make_collinear_vertices(Random& random) {
    PairQuery query = pair_of(random, {with_midpoints(random), with_midpoints(random)}, 3.0);
    if (random.chance(0.5)) place_edge_to_edge(query, random, random.signed_magnitude(-40, -7));
    return query;
}

// All vertices in one point, or along a line in exact steps.
Shape collapsed_polygon(Random& random) {
    const int count = random.integer(2, 8);
    const GridPoint from{random.integer(-1000, 1000), random.integer(-1000, 1000)};
    const GridPoint step =
        random.chance(0.4) ? GridPoint{} : GridPoint{random.integer(-300, 300), random.integer(-300, 300)};
    std::vector<GridPoint> points;
    for (int i = 0; i < count; ++i) points.push_back({from.x + i * step.x, from.y + i * step.y});
    return Shape::from_raw(to_vertices(points, -10, -10), random.chance(0.3) ? 0.25f : 0.0f);
}

PairQuery make_collapsed(Random& random) {
    PairQuery query = pair_of(
        random, {collapsed_polygon(random), random.chance(0.5) ? collapsed_polygon(random) : random_shape(random, 0)},
        2.0);
    if (random.chance(0.3)) {  // exactly on one line or in one point
        query.b = query.a;
        query.pose_b = query.pose_a;
        query.pose_b.position += DVec2{random.integer(-2, 2) / 8.0, 0.0};
    }
    return query;
}

constexpr std::array kThinFamilies{
    PairFamily{"slivers", "10 m x 1e-7 m boxes", seeded<make_slivers>},
    PairFamily{"crossed_slivers", "10 m x 1e-7 m boxes across each other", seeded<make_crossed_slivers>},
    PairFamily{"ulp_edges", "corners cut by an edge of one ulp", seeded<make_ulp_edges>},
    PairFamily{"duplicate_vertices", "vertices given several times", seeded<make_duplicate_vertices>},
    PairFamily{"collinear_vertices", "vertices in the middle of edges", seeded<make_collinear_vertices>},
    PairFamily{"collapsed_polygons", "polygons that are a point or a segment", seeded<make_collapsed>},
};

}  // namespace

std::span<const PairFamily> thin_families() { return kThinFamilies; }

}  // namespace tumble::reference
