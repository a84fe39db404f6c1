// Pairs with ties: equal shapes, common centres, points on the medial axis, regular and elliptic polygons.
#include <algorithm>
#include <array>
#include <cmath>

#include "reference/families/family_lists.hpp"
#include "reference/query/random_shapes.hpp"

namespace tumble::reference {

namespace {

PairQuery make_identical(Random& random) {
    const Shape shape = random_shape(random, random.integer(-4, 4));
    const Pose pose{random.point(8.0), random.rotation()};
    return {shape, shape, pose, pose};
}

Shape shrunk(const Shape& shape, int halvings) {
    std::vector<Vec2> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i)
        vertices.push_back({std::ldexp(shape.vertex(i).x, -halvings), std::ldexp(shape.vertex(i).y, -halvings)});
    return Shape::from_raw(vertices, std::ldexp(shape.radius(), -halvings));
}

PairQuery make_nested(Random& random) {
    PairQuery query;
    query.a = random_shape(random, 0);
    const int halvings = random.integer(0, 6);
    query.b = shrunk(random.chance(0.7) ? query.a : random_shape(random, 0), halvings);
    query.pose_a = query.pose_b = {random.point(8.0), random.rotation()};
    if (random.chance(0.5)) query.pose_b.rotation = random.rotation();
    if (random.chance(0.2)) query.pose_b.position += 0.1 * random.direction();
    return query;
}

// A box, and a symmetric shape whose centre is equally far from two or more of the box's faces or corners.
PairQuery make_medial_axis(Random& random) {
    const double half_height = random.integer(1, 8) / 8.0;
    const double half_width = half_height + random.integer(0, 8) / 8.0;
    PairQuery query;
    query.a = box(half_width, half_height);
    const double side = random.integer(0, 8) / 64.0;
    query.b = side == 0.0 ? Shape::from_raw(std::array{Vec2{}}, random.chance(0.5) ? 0.0f : 0.125f) : box(side, side);
    const double inset = half_height * random.integer(0, 8) / 8.0;  // from the corner inwards, along the bisector
    const DVec2 on_bisector{half_width - inset, half_height - inset};
    const DVec2 on_spine{random.uniform(-1.0, 1.0) * (half_width - half_height), 0.0};
    const DVec2 off_side{0.0, half_height + random.integer(0, 16) / 16.0};
    query.pose_b.position = random.chance(0.5) ? on_bisector : random.chance(0.5) ? on_spine : off_side;
    return query;
}

// An exactly convex polygon of up to `count` points of an ellipse with half axes 2^x_exponent and 2^y_exponent;
// rounding to the grid may drop a few.
Shape ellipse(int count, double phase, int x_exponent, int y_exponent) {
    std::vector<GridPoint> points;
    points.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const SinCos v = sin_cos(phase + 2.0 * kPi * i / count);
        points.push_back({std::llround(0x1p23 * v.cos), std::llround(0x1p23 * v.sin)});
    }
    return Shape::from_raw(to_vertices(convex_hull(std::move(points)), x_exponent - 23, y_exponent - 23), 0.0f);
}

void place_with_ties(PairQuery& query, Random& random) {
    switch (random.integer(0, 4)) {
        case 0: query.pose_b.position = query.pose_a.position; break;
        case 1: query.pose_b.position = query.pose_a.position + random.point(2.0); break;
        case 2: place_vertex_to_vertex(query, random, random.signed_magnitude(-40, 0)); break;
        case 3: place_vertex_to_edge(query, random, random.signed_magnitude(-40, 0)); break;
        default: place_edge_to_edge(query, random, random.signed_magnitude(-40, 0)); break;
    }
}

PairQuery make_round_pair(Random& random, int low, int high, int y_exponent) {
    const auto round_shape = [&] {
        const int count = random.integer(low, high);
        return ellipse(count, random.chance(0.5) ? 0.0 : random.uniform(0.0, kPi), 0, y_exponent);
    };
    PairQuery query{round_shape(), {}, {random.point(2.0), random.rotation()}, {{}, random.rotation()}};
    query.b = random.chance(0.3) ? query.a : random.chance(0.3) ? random_shape(random, 0) : round_shape();
    if (random.chance(0.3)) query.pose_b.rotation = query.pose_a.rotation;
    place_with_ties(query, random);
    return query;
}

PairQuery make_regular(Random& random) { return make_round_pair(random, 3, 20, 0); }
PairQuery make_large_regular(Random& random) { return make_round_pair(random, 65, 1024, 0); }
PairQuery make_large_ellipse(Random& random) { return make_round_pair(random, 65, 1 << random.integer(7, 12), -10); }

constexpr std::array kSymmetricFamilies{
    PairFamily{"identical", "the same shape at the same pose", seeded<make_identical>},
    PairFamily{"nested", "one inside the other, often with a common centre", seeded<make_nested>},
    PairFamily{"medial_axis", "equally far from two or more faces", seeded<make_medial_axis>},
    PairFamily{"regular_polygons", "regular polygons of 3 to 20 vertices, placed with ties", seeded<make_regular>, 0.5},
    PairFamily{"large_regular", "regular polygons of up to 1024 vertices", seeded<make_large_regular>, 0.002,
               FamilyKind::large},
    PairFamily{"large_ellipse", "ellipses of aspect 1000 with up to 4096 vertices", seeded<make_large_ellipse>, 0.001,
               FamilyKind::large},
};

}  // namespace

std::span<const PairFamily> symmetric_families() { return kSymmetricFamilies; }

}  // namespace tumble::reference
