// The intervals of the exact oracle contain the exact numbers, in every family. INTERVALS.md derives their width.
#include "reference/exact/interval_pair.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "reference/exact/exact_geometry.hpp"
#include "reference/families/pair_families.hpp"
#include "reference/query/random.hpp"
#include "support/distance_results.hpp"
#include "tumble/distance.hpp"

using namespace tumble;
using namespace tumble::reference;
using namespace tumble_test;

namespace {

constexpr std::uint64_t kSeed = 20261124;

// A long double is the sum of two doubles.
ExactDyadic exact(long double x) {
    const auto high = static_cast<double>(x);
    return exact_sum({high, static_cast<double>(x - high)});
}

// What was compared: the numbers outside of their intervals, and the largest error in units of the half width.
struct Containment {
    std::uint64_t numbers = 0, undecided = 0, outside = 0;
    double largest_error = 0.0;

    void add(Interval interval, const SignedRoot& root) {
        ++numbers;
        if (!std::isfinite(interval.low) || !std::isfinite(interval.high)) {
            ++undecided;
            return;
        }
        const long double middle = (interval.low + interval.high) / 2, half = (interval.high - interval.low) / 2;
        outside += compare(root, exact(interval.low)) < 0 || compare(root, exact(interval.high)) > 0;
        if (half > 0)
            largest_error =
                std::max(largest_error, static_cast<double>(std::abs(rounded_difference(root, exact(middle))) / half));
    }
};

void add_claims(Containment& total, const IntervalPair& intervals, const ExactPair& pair, VertexPair from,
                VertexPair to, DVec2 direction) {
    const ExactPoint w1 = minkowski_vertex(pair, from), w2 = minkowski_vertex(pair, to), d = exact_direction(direction);
    total.add(intervals.separation(direction), separation(pair, d));
    total.add(intervals.segment_distance(from, to), segment_distance(pair, w1, w2));
    total.add(intervals.face_separation(from, to, direction), claimed_face_separation(pair, w1, w2, d));
}

Containment check_query(const PairQuery& query, Random& random) {
    Containment total;
    const IntervalPair intervals(query);
    const ExactPair pair = exact_pair(query);
    const Certificate claim = distance(query.a, query.pose_a, query.b, query.pose_b).certificate;
    add_claims(total, intervals, pair, claim.pairs[0], claim.pairs[claim.pair_count - 1u], claim.direction);
    const VertexPair from = random_vertices(random, query), to = random_vertices(random, query);
    add_claims(total, intervals, pair, from, to, random.vector(-40, 40));
    for (const EstimatedFace& face : intervals.faces())
        total.add(face.separation, separation(pair, face_normal(pair, face.is_of_a, face.edge)));
    for (const EstimatedSegment& segment : intervals.segments())
        total.add(segment.distance,
                  segment_distance(pair, minkowski_vertex(pair, segment.from), minkowski_vertex(pair, segment.to)));
    return total;
}

}  // namespace

TEST_CASE("in every family the intervals contain the exact separations and distances, with a margin of two") {
    double largest = 0.0;
    for (const PairFamily& family : pair_families()) {
        if (family.kind != FamilyKind::exact || !is_family_selected(family.name)) continue;
        Containment total;
        for (std::uint64_t index = 0; index < pair_count() / 50; ++index) {
            Random random(kSeed, index);
            const Containment part = check_query(family.generate(kSeed, index), random);
            total.numbers += part.numbers;
            total.undecided += part.undecided;
            total.outside += part.outside;
            total.largest_error = std::max(total.largest_error, part.largest_error);
        }
        INFO(family.name);
        CHECK(total.outside == 0);
        CHECK(total.largest_error < 0.5);  // 16 of the 32 u S are derived
        CHECK(20 * total.undecided < total.numbers);
        largest = std::max(largest, total.largest_error);
    }
    if (is_every_family_selected()) CHECK(largest > 1.0 / 32);  // u S: rounding errors are seen
    MESSAGE("largest error " << 32 * largest << " u S, of 16 derived");
}

// Multiples of the edge, rounded, point to either side of it by less than 2^-53: rounding of the cross product, 2^-64,
// changes the side of one in about a thousand.
TEST_CASE("the side of a claimed face is decided only if it is certain") {
    Random random(kSeed, 1);
    const PairQuery query{make_box({1, 1}), make_box({1, 1}), {{}, random.rotation()}, {{3, 1}, random.rotation()}};
    const DVec2 edge = rotate(query.pose_a.rotation, DVec2(query.a.vertex(1)) - DVec2(query.a.vertex(0)));
    const IntervalPair intervals(query);
    const ExactPair pair = exact_pair(query);
    const ExactPoint w1 = minkowski_vertex(pair, {0, 0}), w2 = minkowski_vertex(pair, {1, 0});
    Containment total;
    for (int sample = 0; sample < 50000; ++sample) {
        const DVec2 direction = random.uniform(1.0, 2.0) * edge;
        total.add(intervals.face_separation({0, 0}, {1, 0}, direction),
                  claimed_face_separation(pair, w1, w2, exact_direction(direction)));
    }
    CHECK(total.outside == 0);
    CHECK(total.undecided > 0);
    CHECK(20 * total.undecided < total.numbers);
}

TEST_CASE("intervals decide by their ends alone") {
    CHECK(compare(Interval{1.0L, 2.0L}, Interval{0.0L, 0.5L}) == 1);
    CHECK(compare(Interval{0.0L, 0.5L}, Interval{1.0L, 2.0L}) == -1);
    CHECK_FALSE(compare(Interval{0.0L, 1.0L}, Interval{1.0L, 2.0L}));
    CHECK_FALSE(compare(Interval{1.0L, 1.0L}, Interval{1.0L, 1.0L}));
    CHECK_FALSE(compare(Interval{}, Interval{1.0L, 1.0L}));
}

TEST_CASE("the interval of a sum contains the exact sum") {
    Random random(kSeed, 0);
    for (int sample = 0; sample < 10000; ++sample) {
        const double x = random.signed_magnitude(-30, 30), z = random.signed_magnitude(-70, 30);
        const double y = random.chance(0.3) ? -x : random.signed_magnitude(-30, 30);
        const Interval sum = interval_sum({x, y, z});
        const auto sign_of_sum_minus = [&](long double bound) {
            const auto high = static_cast<double>(bound);
            return sgn(exact_sum({x, y, z, -high, -static_cast<double>(bound - high)}).mantissa);
        };
        CHECK(sign_of_sum_minus(sum.low) >= 0);
        CHECK(sign_of_sum_minus(sum.high) <= 0);
    }
}
