// Pairs far from the origin, of very different size, very small and very large, and with drifted rotations.
#include <array>
#include <cmath>

#include "reference/families/family_lists.hpp"
#include "reference/query/random_shapes.hpp"

namespace tumble::reference {

namespace {

// Half of the pairs almost touch; the others have a random offset.
void place(PairQuery& query, Random& random, double size) {
    if (random.chance(0.5)) {
        place_vertex_to_edge(query, random, size * random.signed_magnitude(-30, -5));
    } else {
        query.pose_b.position = query.pose_a.position + random.point(2.0 * size);
    }
}

template <int Metres>
PairQuery make_far(Random& random) {
    PairQuery query{random_shape(random, 0),
                    random_shape(random, 0),
                    {double{Metres} * random.direction(), random.rotation()},
                    {{}, random.rotation()}};
    place(query, random, 1.0);
    return query;
}

PairQuery make_ground(Random& random) {
    const double half_width = random.uniform(5e3, 5e5), half_height = random.magnitude(0, 5);
    PairQuery query{box(half_width, half_height), random_shape(random, -7), {{}, {}}, {{}, random.rotation()}};
    if (random.chance(0.5)) query.pose_a.rotation = random.rotation();
    const DVec2 up = rotate(query.pose_a.rotation, DVec2{0.0, 1.0});
    const DVec2 on_ground = rotate(query.pose_a.rotation, DVec2{random.uniform(-1.0, 1.0) * half_width, half_height});
    const double gap = random.signed_magnitude(-24, -5);
    query.pose_b.position =
        on_ground + (gap + query.b.radius()) * up - support_point(query.b, query.pose_b.rotation, -up);
    return query;
}

PairQuery make_scales(Random& random) {
    const int exponent = random.integer(-40, 40);
    const double size = std::ldexp(1.0, exponent);
    PairQuery query{random_shape(random, exponent),
                    random_shape(random, exponent),
                    {random.point(4.0 * size), random.rotation()},
                    {{}, random.rotation()}};
    place(query, random, size);
    return query;
}

PairQuery make_mixed_scales(Random& random) {
    const int exponent = random.integer(-20, 20);
    PairQuery query{random_shape(random, random.integer(-20, 20)),
                    random_shape(random, exponent),
                    {{}, random.rotation()},
                    {{}, random.rotation()}};
    place(query, random, std::ldexp(1.0, exponent));
    return query;
}

Rotation drifted(Random& random) {
    const Rotation q = random.rotation();
    const auto factor =
        static_cast<float>(random.chance(0.2) ? random.uniform(0.5, 2.0) : 1.0 + random.signed_magnitude(-22, -5));
    return {factor * q.c, factor * q.s};
}

PairQuery make_drifted(Random& random) {
    PairQuery query{
        random_shape(random, 0), random_shape(random, 0), {random.point(4.0), drifted(random)}, {{}, drifted(random)}};
    place(query, random, 1.0);
    return query;
}

constexpr std::array kScaleFamilies{
    PairFamily{"far_1km", "1 m shapes 1 km from the origin", seeded<make_far<1000>>},
    PairFamily{"far_16km", "1 m shapes 16 km from the origin", seeded<make_far<16000>>},
    PairFamily{"far_100km", "1 m shapes 100 km from the origin", seeded<make_far<100000>>},
    PairFamily{"ground", "a ground of 10 to 1000 km under a 1 cm shape", seeded<make_ground>},
    PairFamily{"scales", "both shapes between 1e-12 and 1e12 m", seeded<make_scales>},
    PairFamily{"mixed_scales", "each shape between 1e-6 and 1e6 m, on its own", seeded<make_mixed_scales>},
    PairFamily{"drifted_rotations", "rotations that are not of unit length", seeded<make_drifted>},
};

}  // namespace

std::span<const PairFamily> scale_families() { return kScaleFamilies; }

}  // namespace tumble::reference
