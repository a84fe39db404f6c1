// Lengths at both ends of the number range, and input that is not finite.
#include <array>
#include <cmath>
#include <limits>

#include "reference/families/family_lists.hpp"
#include "reference/query/random_shapes.hpp"

namespace tumble::reference {

namespace {

// A shape of small integers times 2^exponent, exact down to the smallest denormal float. No vertex is the origin: the
// scale of a shape with a single vertex there would be the offset alone, whose square may underflow.
Shape grid_shape(Random& random, int exponent) {
    std::vector<GridPoint> points;
    const int count = random.integer(1, 8);
    for (int i = 0; i < count; ++i) points.push_back({2 * random.integer(-32, 31) + 1, random.integer(-63, 63)});
    const float radius = random.chance(0.5) ? 0.0f : std::ldexp(static_cast<float>(random.integer(1, 63)), exponent);
    return Shape::from_raw(to_vertices(convex_hull(std::move(points)), exponent, exponent), radius);
}

PairQuery grid_pair(Random& random, int exponent, int position_exponent) {
    const auto position = [&] { return std::ldexp(1.0, position_exponent) * random.point(100.0); };
    return {grid_shape(random, exponent),
            grid_shape(random, exponent),
            {position(), random.rotation()},
            {position(), random.rotation()}};
}

PairQuery make_denormal(Random& random) {
    const int exponent = random.integer(-149, -126);
    return grid_pair(random, exponent, exponent);
}

PairQuery make_tiny_offset(Random& random) {
    const int exponent = random.integer(-149, -4);
    PairQuery query = grid_pair(random, exponent, random.integer(-1074, -150));
    if (random.chance(0.3)) query.b = query.a;
    return query;
}

PairQuery make_huge(Random& random) {
    const int exponent = random.integer(40, 121);
    return grid_pair(random, exponent, exponent);
}

PairQuery make_huge_offset(Random& random) {
    const int exponent = random.integer(-20, 100);
    return grid_pair(random, exponent, random.integer(100, 490));
}

// Beyond 2^500 m, products of squares leave the range of double, and the answer must be `invalid`.
PairQuery make_out_of_range(Random& random) {
    PairQuery query = grid_pair(random, random.integer(-20, 100), 0);
    query.pose_b.position += random.vector(502, 1020);
    return query;
}

PairQuery make_not_finite(Random& random) {
    PairQuery query = grid_pair(random, -6, -6);
    const double bad = random.chance(0.5) ? std::numeric_limits<double>::quiet_NaN()
                                          : random.sign() * std::numeric_limits<double>::infinity();
    const auto bad_float = static_cast<float>(bad);
    if (random.chance(0.5)) query = query.swapped();
    switch (random.integer(0, 5)) {
        case 0: query.pose_a.position.x = bad; break;
        case 1: query.pose_b.position.y = bad; break;
        case 2: query.pose_a.rotation.c = bad_float; break;
        case 3: query.pose_b.rotation.s = bad_float; break;
        case 4: query.a = Shape{}; break;
        default: {
            std::vector<Vec2> vertices;
            for (int i = 0; i < query.a.vertex_count(); ++i) vertices.push_back(query.a.vertex(i));
            vertices[static_cast<std::size_t>(random.integer(0, query.a.vertex_count() - 1))].x = bad_float;
            query.a = Shape::from_raw(vertices, query.a.radius());
        }
    }
    return query;
}

constexpr std::array kExtremeFamilies{
    PairFamily{"denormal", "shapes of denormal floats", seeded<make_denormal>},
    PairFamily{"tiny_offset", "offsets down to the smallest denormal double", seeded<make_tiny_offset>},
    PairFamily{"huge", "shapes up to the largest float", seeded<make_huge>},
    PairFamily{"huge_offset", "positions far outside the range of float", seeded<make_huge_offset>},
    PairFamily{"out_of_range", "offsets whose fourth powers leave the range of double", seeded<make_out_of_range>, 0.1,
               FamilyKind::invalid},
    PairFamily{"not_finite", "a NaN, an infinity or a shape without vertices", seeded<make_not_finite>, 0.1,
               FamilyKind::invalid},
};

}  // namespace

std::span<const PairFamily> extreme_families() { return kExtremeFamilies; }

}  // namespace tumble::reference
