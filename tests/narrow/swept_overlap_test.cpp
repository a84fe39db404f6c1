// The swept test against the closed form of the cast, which shares no algorithm with it, and by hand.
#include <doctest/doctest.h>

#include <limits>

#include "support/brute_distance.hpp"
#include "support/moving_pairs.hpp"
#include "tumble/cast.hpp"

using namespace tumble;
using tumble_test::Random;

namespace {

bool is_met(const CastResult& cast) { return cast.status == CastStatus::hit || cast.status == CastStatus::overlapping; }

}  // namespace

TEST_CASE("the swept test reports an overlap exactly when the cast hits") {
    int met = 0, touching = 0;
    const std::uint64_t count = tumble_test::pair_count();
    for (std::uint64_t index = 0; index < count; ++index) {
        Random random(1, index);
        const Shape a = tumble_test::random_shape(random, tumble_test::random_kind(random), 1.0);
        const Shape b = tumble_test::random_shape(random, tumble_test::random_kind(random), random.uniform(0.3, 3.0));
        const Pose pose_a{random.point(1e3), random.rotation()};
        const Pose pose_b{pose_a.position + random.point(5.0), random.rotation()};
        const DVec2 motion = random.uniform(0.2, 4.0) * (pose_a.position + random.point(1.2) - pose_b.position);
        const CastResult cast = cast_shape(a, pose_a, b, pose_b, motion);
        const DistanceStatus swept = swept_overlap(a, pose_a, b, pose_b, motion);
        INFO("pair ", index);
        met += is_met(cast);
        touching += swept == DistanceStatus::touching;
        if (swept != DistanceStatus::touching) REQUIRE((swept == DistanceStatus::overlapping) == is_met(cast));
        REQUIRE(swept == swept_overlap(b, pose_b, a, pose_a, -motion));
    }
    CHECK(met > 0.3 * static_cast<double>(count));
    CHECK(met < 0.7 * static_cast<double>(count));
    // Capsules and segments whose cores cross have radius 0 between them: only exact contact is undecided.
    CHECK(touching < 0.001 * static_cast<double>(count));
}

TEST_CASE("a bullet that is on either side of a wall at both ends crossed it") {
    const Shape wall = make_box({0.1f, 10}), bullet = make_circle(0.05f), post = make_segment({0, -1}, {0, 1});
    const auto swept = [&](const Shape& a, double y) { return swept_overlap(a, {}, bullet, {{-50, y}, {}}, {100, 0}); };
    CHECK(swept(wall, 0) == DistanceStatus::overlapping);
    CHECK(swept(post, 0) == DistanceStatus::overlapping);
    CHECK(swept(post, 1.04) == DistanceStatus::overlapping);
    CHECK(swept(post, 1.06) == DistanceStatus::separated);
    CHECK(swept_overlap(wall, {}, bullet, {{-50, 0}, {}}, {49, 0}) == DistanceStatus::separated);
    CHECK(swept_overlap(wall, {}, bullet, {{-50, 0}, {}}, {-100, 0}) == DistanceStatus::separated);
}

TEST_CASE("an origin on a chord of the difference is inside, on its boundary it is touching") {
    // Equal boxes, the centre of one moves through that of the other: every simplex along the path is symmetric.
    const Shape box = make_box({2, 2});
    CHECK(swept_overlap(box, {}, box, {{4, 0}, {}}, {-8, 0}) == DistanceStatus::overlapping);
    CHECK(swept_overlap(box, {}, box, {{4, 4}, {}}, {-8, -8}) == DistanceStatus::overlapping);
    CHECK(swept_overlap(box, {}, box, {{0, 0}, {}}, {0, 0}) == DistanceStatus::overlapping);
    CHECK(swept_overlap(box, {}, box, {{4, 2}, {}}, {-8, 0}) == DistanceStatus::touching);
    CHECK(swept_overlap(box, {}, box, {{4, 0}, {}}, {-2, 0}) == DistanceStatus::touching);
    CHECK(swept_overlap(box, {}, box, {{4, 2.0000001}, {}}, {-8, 0}) == DistanceStatus::separated);
}

TEST_CASE("without a number there is no answer") {
    const Shape box = make_box({2, 2});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(swept_overlap(box, {}, box, {{4, 0}, {}}, {nan, 0}) == DistanceStatus::invalid);
    CHECK(swept_overlap(box, {{nan, 0}, {}}, box, {{4, 0}, {}}, {1, 0}) == DistanceStatus::invalid);
    CHECK(swept_overlap(box, {}, Shape{}, {{4, 0}, {}}, {1, 0}) == DistanceStatus::invalid);
}
