// Signed distances and bounds against those over every vertex and edge in long double.
#include <doctest/doctest.h>

#include <array>

#include "support/brute_distance.hpp"
#include "support/random_pairs.hpp"

using namespace tumble;
using namespace tumble_test;

namespace {

struct Tally {
    int pairs = 0;
    int separated = 0;
    int overlapping = 0;
    double worst_error = 0.0;  // in units of u (RA + RB + |p|)

    void judge(const Pair& pair) {
        const DistanceResult found = measure(pair);
        const Real exact = brute_distance(pair.a, pair.pose_a, pair.b, pair.pose_b);
        ++pairs;
        separated += found.status == DistanceStatus::separated;
        overlapping += found.status == DistanceStatus::overlapping;
        worst_error = std::max(worst_error, static_cast<double>(std::abs(found.distance - exact)) / rounding_of(pair));
        CHECK(found.lower <= exact);
        CHECK(exact <= found.upper);
        CHECK(found.lower <= found.distance);
        CHECK(found.distance <= found.upper);
        CHECK_FALSE((found.status == DistanceStatus::separated && exact <= 0));
        CHECK_FALSE((found.status == DistanceStatus::overlapping && exact >= 0));
        CHECK_FALSE(found.reached_cap);
    }

    // Both statuses occur often enough to be tested, and the error is within the bound that the header derives.
    void check(double share_from, double share_to) const {
        CHECK(separated >= share_from * pairs);
        CHECK(separated <= share_to * pairs);
        CHECK(worst_error < 16.0);
        CHECK(worst_error > 0.1);
    }
};

}  // namespace

TEST_CASE("the bounds contain the brute-force distance of any pair") {
    PairSource source(51);
    Tally tally;
    for (int sample = 0; sample < 20000; ++sample) tally.judge(source.pair());
    tally.check(0.5, 0.95);
}

TEST_CASE("the bounds contain the brute-force distance at gaps and depths of 1e-12 to 0.1 m") {
    PairSource source(52);
    Tally tally;
    for (int sample = 0; sample < 20000; ++sample) tally.judge(source.near_pair());
    tally.check(0.4, 0.8);
}

TEST_CASE("the bounds contain the brute-force distance of parallel and almost parallel boxes") {
    PairSource source(53);
    Tally tally;
    for (int sample = 0; sample < 20000; ++sample) {
        const auto box = [&] {
            return make_box({static_cast<float>(source.uniform(0.1, 2)), static_cast<float>(source.uniform(0.1, 2))});
        };
        Pair pair{box(), source.pose(1), box(), source.pose(1)};
        pair.pose_b.rotation = pair.pose_a.rotation;
        if (source.coin())
            pair.pose_b.rotation = make_rotation(angle(pair.pose_a.rotation) + std::pow(10.0, source.uniform(-8, -2)));
        PairSource::move_to_gap(pair, (source.coin() ? 1 : -1) * std::pow(10.0, source.uniform(-12, -2)));
        tally.judge(pair);
    }
    tally.check(0.4, 0.6);
}

TEST_CASE("the bounds contain the brute-force distance of slivers of 10 x 1e-7, crossed and against boxes") {
    PairSource source(54);
    Tally tally;
    for (int sample = 0; sample < 20000; ++sample) {
        Pair pair{make_box({10, 1e-7f}), source.pose(1), source.coin() ? make_box({10, 1e-7f}) : make_box({1, 1}),
                  source.pose(6)};
        tally.judge(pair);
    }
    tally.check(0.2, 0.8);
}

TEST_CASE("the bounds contain the brute-force distance of a kilometre and more against a centimetre") {
    PairSource source(55);
    Tally tally;
    for (int sample = 0; sample < 20000; ++sample) {
        Pair pair{source.shape(std::pow(10.0, source.uniform(3, 6))), source.pose(1), source.shape(0.01), {}};
        const double reach = 2.0 * pair.a.core_radius();
        pair.pose_b = source.pose(reach);
        PairSource::move_to_gap(pair, (source.coin() ? 1 : -1) * std::pow(10.0, source.uniform(-6, -2)));
        tally.judge(pair);
    }
    tally.check(0.3, 0.8);
}

TEST_CASE("the bounds contain the brute-force distance of polygons with an edge of one ulp") {
    PairSource source(56);
    Tally tally;
    const float ulp = 0x1p-23f;
    for (int sample = 0; sample < 20000; ++sample) {
        // A pentagon whose top is cut by an edge of one ulp, seen from above.
        const std::array<Vec2, 5> cut = {
            {{0, 0}, {2, 0}, {1 + ulp, 1}, {1, 1 + (source.coin() ? 0 : ulp)}, {0.5f, 0.9f}}};
        Pair pair{Shape::from_raw(cut, 0), source.pose(1), source.shape(1), source.pose(2)};
        PairSource::move_to_gap(pair, (source.coin() ? 1 : -1) * std::pow(10.0, source.uniform(-12, -2)));
        tally.judge(pair);
    }
    tally.check(0.3, 0.8);
}

TEST_CASE("the bounds contain the brute-force distance of ellipses of up to a thousand vertices") {
    PairSource source(57);
    Tally tally;
    for (int sample = 0; sample < 200; ++sample) {
        Pair pair{source.ellipse(9 + source.below(992), 1, source.uniform(0.001, 1)), source.pose(1),
                  source.ellipse(3 + source.below(98), 1, source.uniform(0.001, 1)), source.pose(1)};
        PairSource::move_to_gap(pair, (source.coin() ? 1 : -1) * std::pow(10.0, source.uniform(-9, -2)));
        tally.judge(pair);
    }
    tally.check(0.3, 0.7);
}

TEST_CASE("the status is exact for boxes on a dyadic grid, in every quarter turn") {
    PairSource source(58);
    const Shape box = make_box({1, 1});
    int touching = 0, separated = 0;
    for (int sample = 0; sample < 20000; ++sample) {
        const auto grid = [&] { return (source.below(17) - 8) / 4.0; };
        const Pair pair{box,
                        {{grid(), grid()}, make_rotation_degrees(90 * source.below(4))},
                        source.below(3) ? box : make_segment({-0.5f, -0.25f}, {0.5f, 0.25f}),
                        {{grid(), grid()}, make_rotation_degrees(90 * source.below(4))}};
        const DistanceResult found = measure(pair);
        const Real exact = brute_distance(pair.a, pair.pose_a, pair.b, pair.pose_b);
        CHECK((exact == 0) == (found.status == DistanceStatus::touching));
        CHECK((exact > 0) == (found.status == DistanceStatus::separated));
        touching += exact == 0;
        separated += exact > 0;
    }
    CHECK(touching > 1000);
    CHECK(separated > 6000);
}
