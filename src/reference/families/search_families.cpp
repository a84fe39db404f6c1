// Pairs that follow from earlier ones: smooth motion, and local searches for the hardest pair.
#include <algorithm>
#include <array>
#include <cmath>

#include "reference/exact/exact_distance.hpp"
#include "reference/families/family_lists.hpp"
#include "reference/query/random_shapes.hpp"
#include "tumble/distance.hpp"

namespace tumble::reference {

namespace {

// B flies past A and turns: apart, touching or overlapping, and apart again.
PairQuery make_trajectory(std::uint64_t seed, std::uint64_t index) {
    Random random(seed, index / kTrajectorySteps);
    PairQuery query{random_shape(random, 0), random_shape(random, 0), {random.point(4.0), random.rotation()}, {}};
    const double time = static_cast<double>(index % kTrajectorySteps) / static_cast<double>(kTrajectorySteps - 1);
    const DVec2 start = random.point(4.0), end = random.point(4.0);
    const double angle = random.uniform(-kPi, kPi), turn = random.uniform(-2.0, 2.0);
    query.pose_b = {query.pose_a.position + (start + time * (end - start)), make_rotation(angle + time * turn)};
    return query;
}

// A neighbour in the space of poses, from one ulp to half a metre away.
PairQuery mutated(const PairQuery& query, Random& random) {
    PairQuery next = query;
    switch (random.integer(0, 3)) {
        case 0: next.pose_b.position += random.vector(-52, -1); break;
        case 1: next.pose_b.position.x = std::nextafter(next.pose_b.position.x, random.sign() * HUGE_VAL); break;
        case 2:
            next.pose_b.rotation.s = std::nextafterf(next.pose_b.rotation.s, random.chance(0.5) ? 2.0f : -2.0f);
            break;
        default: next.pose_b.rotation = make_rotation(angle(next.pose_b.rotation) + random.signed_magnitude(-24, -2));
    }
    return next;
}

// How hard a pair is. If that is certainly less than `enough`, the answer may be 0.
using Hardness = double (*)(const PairQuery& query, double enough);

// Iterations of the GJK loop. distance() answers many small pairs without that loop.
double iterations(const PairQuery& query, double) {
    return gjk_distance(query.a, query.pose_a, query.b, query.pose_b).iterations;
}

double relative_error(const PairQuery& query, double enough) {
    const double answer = distance(query.a, query.pose_a, query.b, query.pose_b).distance;
    const ExactDistance exact(query);
    const double scale = error_scale(query), too_small = 0.999 * enough * scale;
    if (exact.compare(answer, too_small) < 0 && exact.compare(answer, -too_small) > 0) return 0.0;
    return std::abs(exact.minus(answer)) / scale;
}

PairQuery climb(Random& random, Hardness hardness, int tries) {
    PairQuery worst{random_polygon(random, 8, 0),
                    random_polygon(random, 8, 0),
                    {{}, random.rotation()},
                    {random.point(2.0), random.rotation()}};
    double hardest = hardness(worst, 0.0);
    for (int i = 0; i < tries; ++i) {
        PairQuery candidate = mutated(worst, random);
        const double value = hardness(candidate, hardest);
        if (value < hardest) continue;
        hardest = value;
        worst = std::move(candidate);
    }
    return worst;
}

PairQuery make_most_iterations(Random& random) { return climb(random, iterations, 100); }
PairQuery make_largest_error(Random& random) { return climb(random, relative_error, 10); }

constexpr std::array kSearchFamilies{
    PairFamily{"trajectory", "two shapes in smooth motion, 64 steps each", make_trajectory, 2.0},
    PairFamily{"most_iterations", "found by local search for many iterations", seeded<make_most_iterations>, 0.05},
    PairFamily{"largest_error", "found by local search for a large error", seeded<make_largest_error>, 0.02},
};

}  // namespace

std::span<const PairFamily> search_families() { return kSearchFamilies; }

}  // namespace tumble::reference
