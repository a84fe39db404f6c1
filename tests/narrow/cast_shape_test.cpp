// Linear casts against hand-worked cases and against an independent distance: the distance
// along a translation is convex, so that its signs at the ends of the bracket decide everything.
#include "tumble/cast.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "support/brute_distance.hpp"
#include "support/moving_pairs.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::test;
using tumble_test::Random;
using tumble_test::Real;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Query {
    Shape a, b;
    Pose pose_a, pose_b;
    DVec2 translation;
    double target = 0.0;

    CastResult cast() const { return cast_shape(a, pose_a, b, pose_b, translation, target); }
    CastResult swapped() const { return cast_shape(b, pose_b, a, pose_a, -translation, target); }
};

// The stated error bound, 16 u times the sizes and offsets involved.
Real error_of(const Query& query) {
    return 16 * 0x1p-53L *
           (query.a.core_radius() + query.b.core_radius() + query.a.radius() + query.b.radius() +
            length(query.pose_b.position - query.pose_a.position) + query.target);
}

// Signed distance less the target, as a function of the fraction.
class Gap {
public:
    explicit Gap(const Query& query)
        : a_(tumble_test::world_vertices(query.a, query.pose_a, query.pose_a.position)),
          b_(tumble_test::world_vertices(query.b, query.pose_b, query.pose_a.position)),
          motion_{query.translation.x, query.translation.y},
          reach_(static_cast<Real>(query.a.radius()) + query.b.radius() + query.target) {}

    Real operator()(Real fraction) const {
        std::vector<tumble_test::Point> moved = b_;
        for (tumble_test::Point& point : moved) point = point + fraction * motion_;
        return tumble_test::core_distance(a_, moved) - reach_;
    }

    // The gap is convex along the path: ternary search, to 2^-60 of it.
    Real smallest() const {
        Real low = 0, high = 1;
        for (int i = 0; i < 104; ++i) {
            const Real left = (2 * low + high) / 3, right = (low + 2 * high) / 3;
            ((*this)(left) < (*this)(right) ? high : low) = (*this)(left) < (*this)(right) ? right : left;
        }
        return std::min({(*this)(low), (*this)(0), (*this)(1)});
    }

    // Along a fixed unit direction from A to B.
    Real along(DVec2 normal, Real fraction) const {
        const tumble_test::Point n{normal.x, normal.y};
        Real highest_a = -INFINITY, lowest_b = INFINITY;
        for (const tumble_test::Point point : a_) highest_a = std::max(highest_a, dot(n, point));
        for (const tumble_test::Point point : b_) lowest_b = std::min(lowest_b, dot(n, point + fraction * motion_));
        return lowest_b - highest_a - reach_;
    }

private:
    std::vector<tumble_test::Point> a_, b_;
    tumble_test::Point motion_;
    Real reach_;
};

struct Tally {
    int hits = 0, misses = 0, overlaps = 0, grazes = 0;
    int failures = 0;
};

// The point lies on the surface of A, at the radius from its core.
bool is_on_surface(const Query& query, DVec2 point, Real tolerance) {
    const Shape at = Shape::from_raw(std::vector<Vec2>{{}}, 0.0f);
    const Real away = tumble_test::brute_distance(query.a, query.pose_a, at, {point, {}});
    // The world point is rounded to its own magnitude.
    return std::abs(away) <= tolerance + 0x1p-52L * (std::abs(point.x) + std::abs(point.y));
}

// Every claim of the header on one query. True if they hold.
bool holds(const Query& query, Tally& tally) {
    const CastResult result = query.cast();
    const Gap gap(query);
    const Real error = error_of(query), start = gap(0);
    switch (result.status) {
        case CastStatus::invalid: return false;
        case CastStatus::overlapping: ++tally.overlaps; return start < 0;
        case CastStatus::miss: {
            ++tally.misses;
            const Real smallest = gap.smallest();
            if (smallest < 4 * error) ++tally.grazes;
            return smallest >= -4 * error;
        }
        case CastStatus::hit: break;
    }
    ++tally.hits;
    if (!(result.lower <= result.fraction && result.fraction <= result.upper)) return false;
    if (!(result.fraction >= 0.0 && result.fraction <= 1.0)) return false;
    if (!(start >= -2 * error)) return false;
    // The normal proves that the shapes were apart until here, and that they are near.
    const Real proved = gap.along(result.normal, result.fraction);
    if (!(std::abs(length(result.normal) - 1.0) < 1e-15)) return false;
    if (!is_on_surface(query, result.point, 4 * error)) return false;
    if (gap(result.upper) > 0 && result.upper <= 1.0) {
        ++tally.grazes;
        return std::abs(gap.smallest()) <= 4 * error;
    }
    return gap(result.lower) >= (result.lower > 0.0 ? 0 : -2 * error) && std::abs(gap(result.fraction)) <= 4 * error &&
           std::abs(proved) <= 8 * error;
}

Query random_query(Random& random, tumble_test::ShapeKind kind_a, tumble_test::ShapeKind kind_b) {
    Query query;
    query.a = tumble_test::random_shape(random, kind_a, 1.0);
    query.b = tumble_test::random_shape(random, kind_b, random.uniform(0.3, 3.0));
    query.pose_a = {random.point(random.chance(0.2) ? 1e4 : 1.0), random.rotation()};
    query.pose_b = {query.pose_a.position + random.point(5.0), random.rotation()};
    if (random.chance(0.3)) query.pose_b.rotation = query.pose_a.rotation;
    // Aimed at a point near A, so that about half of them hit, and some stop short.
    const DVec2 aim = query.pose_a.position + random.point(1.2) - query.pose_b.position;
    query.translation = random.uniform(0.2, 4.0) * aim;
    if (random.chance(0.3)) query.target = random.uniform(0.0, 0.3);
    return query;
}

}  // namespace

TEST_CASE("casts of every kind of pair keep their bracket by an independent distance") {
    Tally tally;
    std::uint64_t index = 0;
    for (; index < tumble_test::pair_count(); ++index) {
        Random random(1, index);
        const Query query = random_query(random, tumble_test::random_kind(random), tumble_test::random_kind(random));
        if (holds(query, tally)) continue;
        ++tally.failures;
        INFO("pair ", index);
        CHECK(holds(query, tally));
        if (tally.failures == 5) break;
    }
    const auto count = static_cast<double>(index);
    CHECK(tally.hits > 0.3 * count);
    CHECK(tally.misses > 0.2 * count);
    CHECK(tally.overlaps > 0.02 * count);
    CHECK(tally.grazes < 0.01 * count);
}

TEST_CASE("swapping the shapes and reversing the motion gives the same bits") {
    for (std::uint64_t index = 0; index < tumble_test::pair_count(); ++index) {
        Random random(2, index);
        const Query query = random_query(random, tumble_test::random_kind(random), tumble_test::random_kind(random));
        const CastResult result = query.cast(), swapped = query.swapped();
        INFO("pair ", index);
        REQUIRE(result.status == swapped.status);
        REQUIRE(result.fraction == swapped.fraction);
        REQUIRE(result.lower == swapped.lower);
        REQUIRE(result.upper == swapped.upper);
        REQUIRE(result.normal == -swapped.normal);
    }
}

TEST_CASE("scaling everything by a power of two scales the answer bit for bit") {
    for (std::uint64_t index = 0; index < tumble_test::pair_count(); ++index) {
        Random random(3, index);
        const Query query = random_query(random, tumble_test::random_kind(random), tumble_test::random_kind(random));
        const int exponent = random.integer(-60, 60);
        Query scaled = query;
        scaled.a = tumble_test::scaled(query.a, exponent);
        scaled.b = tumble_test::scaled(query.b, exponent);
        const double factor = std::ldexp(1.0, exponent);
        scaled.pose_a.position = factor * query.pose_a.position;
        scaled.pose_b.position = factor * query.pose_b.position;
        scaled.translation = factor * query.translation;
        scaled.target = factor * query.target;
        const CastResult expected = query.cast(), result = scaled.cast();
        INFO("pair ", index);
        REQUIRE(result.status == expected.status);
        REQUIRE(result.fraction == expected.fraction);
        REQUIRE(result.lower == expected.lower);
        REQUIRE(result.upper == expected.upper);
        REQUIRE(result.normal == expected.normal);
        REQUIRE(result.point == factor * expected.point);
    }
}

TEST_CASE("a box hits a box face to face at hand-computed fractions") {
    // Half sides 1 and 1/2, centres 4 apart: a gap of 2.5, half of the motion of 5.
    const Query query{make_box({2, 2}), make_box({1, 1}), {}, {{4, 0}, {}}, {-5, 0}};
    const CastResult result = query.cast();
    CHECK(result.status == CastStatus::hit);
    CHECK(result.fraction == 0.5);
    CHECK(result.lower < 0.5);
    CHECK(result.upper > 0.5);
    CHECK(result.upper - result.lower < 1e-14);
    CHECK(result.normal == DVec2{1, 0});
    CHECK(result.point.x == 1.0);
    CHECK(std::abs(result.point.y) <= 0.5);
}

TEST_CASE("circles hit where a right triangle gives the fraction") {
    // Centres (0, 0) and (10, 3) with radii 2 and 3: B moves left and touches A with its centre at (4, 3), after 6 m
    // of 12 m.
    const Query query{make_circle(2), make_circle(3), {}, {{10, 3}, {}}, {-12, 0}};
    const CastResult result = query.cast();
    CHECK(result.status == CastStatus::hit);
    CHECK(near(result.fraction, 0.5, kDouble));
    CHECK(near(result.normal.x, 0.8, kDouble));
    CHECK(near(result.normal.y, 0.6, kDouble));
    CHECK(near(result.point.x, 1.6, kDouble));
    CHECK(near(result.point.y, 1.2, kDouble));
}

TEST_CASE("the target distance is where the cast stops") {
    Query query{make_box({2, 2}), make_box({1, 1}), {}, {{4, 0}, {}}, {-5, 0}, 0.5};
    CHECK(query.cast().fraction == 0.4);
    CHECK(query.cast().point.x == 1.0);
    query.target = 2.5;  // already there, and approaching
    CHECK(query.cast().status == CastStatus::hit);
    CHECK(query.cast().fraction == 0.0);
    query.target = 3.0;
    CHECK(query.cast().status == CastStatus::overlapping);
}

// box3d #32 reported such a cast as a hit.
TEST_CASE("a cast that starts at or near a surface and recedes or slides is a miss") {
    const Shape box = make_box({2, 2}), ball = make_circle(0.5f),
                triangle = make_polygon(std::vector<Vec2>{{0, 0}, {1, -1}, {1, 1}});
    for (const Shape& mover : {box, ball, triangle})
        for (const double gap : {0.0, 1e-17, 1e-12, 1e-6}) {
            const double touching = 1.0 + (mover == box ? 1.0 : mover == ball ? 0.5 : 0.0);
            Query query{box, mover, {}, {{touching + gap, 0.25}, {}}, {3, 0.5}};
            CHECK(query.cast().status == CastStatus::miss);
            query.translation = {0, 5};
            CHECK(query.cast().status == CastStatus::miss);
            query.translation = {0, 0};
            CHECK(query.cast().status == CastStatus::miss);
            query.translation = {-3, 0.5};
            CHECK(query.cast().status == CastStatus::hit);
            CHECK(near(query.cast().fraction, gap / 3, absolute(1e-15)));
        }
}

// parry #180 missed such hits.
TEST_CASE("moving the input by single ulps never loses the hit") {
    // The corner of a diamond moves exactly towards the corner of a box, and towards a face; no edges are parallel.
    const Shape box = make_box({2, 2}), diamond = make_polygon(std::vector<Vec2>{{-1, 0}, {0, -1}, {1, 0}, {0, 1}});
    for (int ulps = -40; ulps <= 40; ++ulps)
        for (const double aim : {0.0, 0.5, 0.999999, 1.9}) {
            double y = aim;
            for (int i = 0; i < std::abs(ulps); ++i) y = std::nextafter(y, ulps < 0 ? -kInfinity : kInfinity);
            const Query query{box, diamond, {}, {{8, y}, {}}, {-12, 0}};
            INFO("ulps ", ulps, " aim ", aim);
            CHECK(query.cast().status == CastStatus::hit);
            CHECK(near(query.cast().fraction, (aim > 1 ? 6.9 : 6.0) / 12, kDouble));
        }
}

TEST_CASE("shapes without area hit, too") {
    const Shape point = make_circle(0), upright = make_segment({0, -1}, {0, 1}), level = make_segment({-1, 0}, {1, 0});
    const auto fraction = [](const Shape& a, const Shape& b, DVec2 from, DVec2 motion) {
        const CastResult result = cast_shape(a, {}, b, {from, {}}, motion);
        return result.status == CastStatus::hit ? result.fraction : -1.0;
    };
    CHECK(fraction(upright, point, {4, 0.5}, {-8, 0}) == 0.5);
    CHECK(fraction(upright, upright, {4, 1.5}, {-8, 0}) == 0.5);
    CHECK(fraction(upright, level, {4, 1.0}, {-8, 0}) == 0.375);
    CHECK(fraction(level, level, {8, 0}, {-8, 0}) == 0.75);
    CHECK(near(fraction(point, point, {4, 4}, {-8, -8}), 0.5, kDouble));
    CHECK(fraction(point, point, {4, 4}, {-8, -7}) == -1.0);
    CHECK(fraction(upright, upright, {4, 2.5}, {-8, 0}) == -1.0);
}

TEST_CASE("a cast with a NaN is invalid") {
    const Query good{make_box({2, 2}), make_circle(1), {}, {{4, 0}, {}}, {-5, 0}};
    CHECK(good.cast().status == CastStatus::hit);
    for (const double bad : {kNan, kInfinity, -kInfinity, 1e300}) {
        Query query = good;
        query.translation.y = bad;
        CHECK(query.cast().status == CastStatus::invalid);
        CHECK(std::isnan(query.cast().fraction));
        query = good;
        query.pose_a.position.x = bad;
        CHECK(query.cast().status == CastStatus::invalid);
        query = good;
        query.target = bad;
        CHECK(query.cast().status == CastStatus::invalid);
    }
    Query query = good;
    query.a = Shape{};
    CHECK(query.cast().status == CastStatus::invalid);
    query = good;
    query.target = -1e-9;
    CHECK(query.cast().status == CastStatus::invalid);
}
