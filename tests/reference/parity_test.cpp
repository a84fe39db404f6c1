// The parity run: tumble is never wrong, the result does not depend on the number of threads, and wrong answers are
// detected.
#include "reference/parity/parity.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "reference/parity/judge.hpp"
#include "reference/parity/witness.hpp"
#include "reference/query/random_shapes.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::reference;
using namespace tumble::test;

namespace {

PairQuery boxes_apart(double gap) { return {box(0.5, 0.5), box(0.5, 0.5), {}, {{1.0 + gap, 0.125}, {}}}; }

ParityRow judged(const PairQuery& query, const DistanceResult& ours, const std::optional<B2Distance>& box2d) {
    const GroundTruth exact = GroundTruth::of_distance(ExactDistance(query));
    ParityRow row;
    add_comparison(row, {query, ours, box2d}, &exact, {});
    return row;
}

DistanceResult tumble_answer(const PairQuery& query) { return distance(query.a, query.pose_a, query.b, query.pose_b); }

}  // namespace

TEST_SUITE("parity") {
    TEST_CASE("tumble is never wrong over all families") {
        ParityOptions options;
        options.pairs = 200000;
        options.checked_first = 500;
        const ParityResult result = run_parity(options);
        for (const ParityRow& row : result.families) {
            INFO(row.name);
            if (!row.ours_failures.empty())
                INFO(row.ours_failures[0].reason << ": " << to_hex(row.ours_failures[0].query));
            CHECK(row.ours_wrong == 0);
            CHECK(row.ours_witness_wrong == 0);
        }
        const ParityRow total = result.total();
        CHECK(result.passed());
        CHECK(total.pairs == options.pairs);
        CHECK(total.checked_exactly > 20000);
        CHECK(total.box2d_wrong > 1000);  // the run sees its failures
        const ParityRow& ordinary = result.families.at(0);
        CHECK(ordinary.box2d_wrong_distance == 0);
        CHECK(ordinary.max_error_box2d_eps < kParityTolerance);
        MESSAGE(total.pairs << " pairs, ours wrong " << total.ours_wrong << ", Box2D wrong " << total.box2d_wrong
                            << ", " << result.seconds << " s");
    }

    TEST_CASE("the result does not depend on the number of threads") {
        ParityOptions options;
        options.pairs = 20000;
        options.checked_first = 50;
        options.families = {"random", "near_gap", "large_radii"};
        options.threads = 1;
        const ParityResult one = run_parity(options);
        options.threads = 3;
        const ParityResult three = run_parity(options);
        REQUIRE(one.families.size() == 3);
        for (std::size_t i = 0; i < 3; ++i) {
            const ParityRow &x = one.families[i], &y = three.families[i];
            CHECK(x.pairs == y.pairs);
            CHECK(x.checked_exactly == y.checked_exactly);
            CHECK(x.box2d_wrong == y.box2d_wrong);
            CHECK(x.max_error_box2d_m == y.max_error_box2d_m);
            CHECK(x.histogram_box2d.counts == y.histogram_box2d.counts);
            REQUIRE(x.worst_box2d.size() == y.worst_box2d.size());
            for (std::size_t k = 0; k < x.worst_box2d.size(); ++k)
                CHECK(x.worst_box2d[k].index == y.worst_box2d[k].index);
        }
    }

    TEST_CASE("an unknown family is refused") {
        ParityOptions options;
        options.families = {"near_gap", "no_such_family"};
        CHECK_THROWS_AS(run_parity(options), std::invalid_argument);
    }
}

TEST_CASE("the judge attributes an error to the engine that made it") {
    const PairQuery query = boxes_apart(0.25);
    const DistanceResult right = tumble_answer(query);
    const std::optional<B2Distance> box2d = b2_distance(query, true);
    REQUIRE(box2d);
    CHECK(judged(query, right, box2d).ours_wrong == 0);
    CHECK(judged(query, right, box2d).box2d_wrong == 0);

    DistanceResult moved = right;  // every number shifted by 1e-9: the bounds do not contain the exact distance
    moved.distance += 1e-9;
    moved.lower += 1e-9;
    moved.upper += 1e-9;
    CHECK(judged(query, moved, box2d).ours_wrong == 1);
    DistanceResult misnamed = right;
    misnamed.status = DistanceStatus::overlapping;
    CHECK(judged(query, misnamed, box2d).ours_wrong == 1);
    DistanceResult elsewhere = right;
    elsewhere.point_a.x -= 1e-3;
    CHECK(judged(query, elsewhere, box2d).ours_wrong == 0);
    CHECK(judged(query, elsewhere, box2d).ours_witness_wrong == 1);
    DistanceResult loose = right;  // right, but with wide bounds
    loose.lower -= 1e-9;
    loose.upper += 1e-9;
    CHECK(judged(query, loose, box2d).ours_wrong == 0);
    loose.distance += 1e-10;
    CHECK(judged(query, loose, box2d).ours_wrong == 1);
    loose = right;
    loose.lower = -1.0;
    loose.status = DistanceStatus::touching;
    CHECK(judged(query, loose, box2d).ours_wrong == 1);
    DistanceResult unproved = right;
    unproved.certificate.pairs[0].a ^= 1;  // another corner
    CHECK(judged(query, unproved, box2d).ours_wrong == 1);
    DistanceResult unknown = right;
    unknown.lower = NAN;
    CHECK(judged(query, unknown, box2d).ours_wrong == 1);

    B2Distance flag = *box2d;
    flag.distance = 0.0;
    CHECK(judged(query, right, flag).box2d_wrong_flag == 1);
    CHECK(judged(query, right, flag).box2d_wrong_distance == 1);
    B2Distance far = *box2d;
    far.distance += 5.0 * kFloatEpsilon * 1.75;  // S is 1.75: the right side of B
    CHECK(judged(query, right, far).box2d_wrong_distance == 1);
    far.distance -= 2.0 * kFloatEpsilon * 1.75;
    CHECK(judged(query, right, far).box2d_wrong == 0);
}

TEST_CASE("the worst cases of Box2D are wrong overlap flags by severity, then errors of the distance") {
    const auto sample = [](bool wrong_flag, double severity, std::uint64_t index) {
        ParityCase kept;
        kept.box2d_wrong_flag = wrong_flag;
        kept.severity = severity;
        kept.index = index;
        return kept;
    };
    ParityRow first, second;
    first.keep(sample(false, 9.0, 1));
    first.keep(sample(true, 1.0, 2));
    first.keep(sample(false, 7.0, 3));
    second.keep(sample(true, 2.0, 4));
    second.keep(sample(false, 9.0, 5));
    second.keep(sample(false, 0.0, 6));  // no error at all
    first.merge(second);
    REQUIRE(first.worst_box2d.size() == 4);
    const std::array<std::uint64_t, 4> expected{4, 2, 1, 5};
    for (std::size_t i = 0; i < 4; ++i) CHECK(first.worst_box2d[i].index == expected[i]);
}

TEST_CASE("b2Distance gives the hand-worked answers, and input that it cannot take is not passed to it") {
    const std::optional<B2Distance> apart = b2_distance(boxes_apart(0.25), true);
    REQUIRE(apart);
    CHECK(apart->distance == 0.25);
    CHECK(apart->point_a.x == 0.5);
    CHECK(apart->point_b.x == 0.75);
    const PairQuery rounded{box(0.5, 0.5, 0.125), box(0.5, 0.5), {}, {{1.25, 0.0}, {}}};
    const std::optional<B2Distance> with_radii = b2_distance(rounded, true), of_cores = b2_distance(rounded, false);
    REQUIRE(with_radii);
    REQUIRE(of_cores);
    CHECK(with_radii->distance == 0.125);
    CHECK(of_cores->distance == 0.25);
    PairQuery beyond = boxes_apart(0.25);
    beyond.pose_b.position.x = 1e39;  // not finite as a float
    CHECK_FALSE(b2_distance(beyond, true));
    beyond = boxes_apart(0.25);
    beyond.a = Shape{};
    CHECK_FALSE(b2_distance(beyond, true));
}

TEST_CASE("the surface distance is that from the boundary, inside and outside") {
    const Shape rounded = box(1.0, 0.5, 0.25);
    const Pose pose{{10.0, -3.0}, {0.0f, 1.0f}};  // a quarter turn: 0.75 wide to each side, 1.25 high
    CHECK(surface_distance(rounded, pose, {10.75, -3.0}) == 0.0);
    CHECK(surface_distance(rounded, pose, {11.0, -3.0}) == 0.25);
    CHECK(surface_distance(rounded, pose, {10.0, -3.0}) == 0.75);
    CHECK(surface_distance(rounded, pose, {10.0, -1.75}) == 0.0);
    CHECK(surface_distance(Shape::from_raw(std::array{Vec2{}}, 2.0f), {}, {3.0, 4.0}) == 3.0);
}

TEST_CASE("histogram bins are half decades") {
    ErrorHistogram histogram;
    histogram.add(0.0);
    histogram.add(1.5e-20);
    histogram.add(2.0e-7);  // 10^-7 to 10^-6.5: bin 26
    histogram.add(1e30);
    histogram.add(NAN);
    CHECK(histogram.counts.front() == 2);
    CHECK(histogram.counts[26] == 1);
    CHECK(near(ErrorHistogram::lower_edge(26), 1e-7, kDouble));
    CHECK(histogram.counts.back() == 2);
}
