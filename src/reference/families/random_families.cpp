// Ordinary pairs of every kind of shape, like most queries of a game.
#include <array>

#include "reference/families/family_lists.hpp"
#include "reference/query/random_shapes.hpp"

namespace tumble::reference {

namespace {

PairQuery pair_of(Random& random, int exponent_a, int exponent_b, double reach) {
    const double size = std::ldexp(1.0, std::max(exponent_a, exponent_b));
    const DVec2 origin = random.point(8.0 * size);
    return {random_shape(random, exponent_a),
            random_shape(random, exponent_b),
            {origin, random.rotation()},
            {origin + random.point(reach * size), random.rotation()}};
}

PairQuery make_random(Random& random) {
    const int exponent = random.integer(-1, 1);
    return pair_of(random, exponent, exponent + random.integer(-1, 1), 1.0);
}

PairQuery make_random_scale(Random& random) {
    const int exponent = random.integer(-10, 10);
    return pair_of(random, exponent, exponent + random.integer(-4, 4), 1.2);
}

PairQuery make_random_apart(Random& random) {
    const int exponent = random.integer(-2, 2);
    return pair_of(random, exponent, exponent, 50.0);
}

PairQuery make_random_many_vertices(Random& random) {
    PairQuery query = pair_of(random, 0, 0, 2.0);
    query.a = random_polygon(random, 32, 0, random.chance(0.3) ? 0.1 : 0.0);
    if (random.chance(0.5)) query.b = random_polygon(random, 32, 0);
    return query;
}

constexpr std::array kRandomFamilies{
    PairFamily{"random", "every kind of shape, near 1 m, about as many overlapping as apart", seeded<make_random>,
               30.0},
    PairFamily{"random_scale", "sizes from 1 mm to 1 km, up to 16 times apart", seeded<make_random_scale>, 15.0},
    PairFamily{"random_apart", "1 m shapes up to 50 m apart", seeded<make_random_apart>, 10.0},
    PairFamily{"random_many_vertices", "polygons of up to 32 vertices", seeded<make_random_many_vertices>, 0.5},
};

}  // namespace

std::span<const PairFamily> random_families() { return kRandomFamilies; }

}  // namespace tumble::reference
