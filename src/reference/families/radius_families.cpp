// Radii: zero, much larger than the core, and surfaces that touch exactly or almost.
#include <array>
#include <cmath>

#include "reference/families/family_lists.hpp"
#include "reference/query/random_shapes.hpp"

namespace tumble::reference {

namespace {

PairQuery make_large_radii(Random& random) {
    const int exponent = random.integer(-12, -6);
    const auto radius = [&] { return random.chance(0.3) ? 0.0 : random.magnitude(-3, 1); };
    PairQuery query{random_polygon(random, 8, exponent, radius()),
                    random_polygon(random, 8, exponent, radius()),
                    {random.point(4.0), random.rotation()},
                    {{}, random.rotation()}};
    const double gap = random.signed_magnitude(-40, 0);
    if (random.chance(0.5)) {
        place_vertex_to_vertex(query, random, gap);
    } else {
        place_vertex_to_edge(query, random, gap);
    }
    return query;
}

struct Triple {
    int x, y, hypotenuse;
};
constexpr std::array kPythagoras{Triple{3, 4, 5},   Triple{5, 12, 13},  Triple{8, 15, 17},
                                 Triple{7, 24, 25}, Triple{20, 21, 29}, Triple{0, 1, 1}};

// Circles whose centres are exactly rA + rB apart, or a few ulps more or less.
PairQuery make_touching_circles(Random& random) {
    const Triple triple = kPythagoras[static_cast<std::size_t>(random.integer(0, 5))];
    const double multiple = random.integer(1, 1000), unit = std::ldexp(multiple, random.integer(-20, 0));
    const double reach = triple.hypotenuse * unit, radius_a = std::ldexp(std::floor(std::ldexp(reach, 18)), -19);
    const double radius_b = reach - static_cast<float>(radius_a);
    PairQuery query{Shape::from_raw(std::array{Vec2{}}, static_cast<float>(radius_a)),
                    Shape::from_raw(std::array{Vec2{}}, static_cast<float>(radius_b)),
                    {{}, random.rotation()},
                    {{}, random.rotation()}};
    query.pose_b.position = {random.sign() * triple.x * unit, random.sign() * triple.y * unit};
    if (random.chance(0.5)) query.pose_b.position.y *= 1.0 + random.integer(-3, 3) * 0x1p-52;
    if (random.chance(0.5)) query.pose_b.position = -perp(query.pose_b.position);
    return query;
}

// Rounded boxes that rest on each other exactly: all lengths are sums of small dyadic numbers.
PairQuery make_touching_rounded(Random& random) {
    const auto length_of = [&] { return random.integer(1, 255) / 128.0; };
    const double height_a = length_of(), height_b = length_of(), radius_a = length_of(), radius_b = length_of();
    PairQuery query{box(length_of(), height_a, radius_a), box(length_of(), height_b, radius_b), {}, {}};
    const double ulps = random.chance(0.5) ? 0.0 : random.integer(-4, 4) * 0x1p-52;
    query.pose_b.position = {random.uniform(-2.0, 2.0), (height_a + height_b + radius_a + radius_b) * (1.0 + ulps)};
    if (random.chance(0.5)) {
        query.pose_a.rotation = query.pose_b.rotation = {0.0f, 1.0f};
        query.pose_b.position = perp(query.pose_b.position);
    }
    return query;
}

constexpr std::array kRadiusFamilies{
    PairFamily{"large_radii", "radii up to 10 000 times the core, or none", seeded<make_large_radii>},
    PairFamily{"touching_circles", "circles exactly rA + rB apart, or a few ulps off", seeded<make_touching_circles>},
    PairFamily{"touching_rounded", "rounded boxes exactly rA + rB apart, or a few ulps off",
               seeded<make_touching_rounded>},
};

}  // namespace

std::span<const PairFamily> radius_families() { return kRadiusFamilies; }

}  // namespace tumble::reference
