// Time of impact against the distance of exactly moved shapes in long double: between samples the distance cannot
// change faster than the shapes move, so that an interval is proved free by subdividing it.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "support/brute_distance.hpp"
#include "support/moving_pairs.hpp"
#include "support/near.hpp"
#include "tumble/cast.hpp"

using namespace tumble;
using namespace tumble::test;
using tumble_test::Point;
using tumble_test::Random;
using tumble_test::Real;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Query {
    Shape a, b;
    Sweep sweep_a, sweep_b;
    double target = 0.0;

    CastResult impact() const { return time_of_impact(a, sweep_a, b, sweep_b, target); }
};

Real extent_of(const Shape& shape, const Sweep& sweep) {
    return shape.core_radius() + length(DVec2(sweep.local_center));
}

// The allowed error: 24 u of the sizes and paths, less than the sum of the worst cases, and 4 u of the angles times the
// levers.
Real error_of(const Query& query) {
    const Real e_a = extent_of(query.a, query.sweep_a), e_b = extent_of(query.b, query.sweep_b);
    const Real paths =
        length(query.sweep_a.end - query.sweep_a.start) + length(query.sweep_b.end - query.sweep_b.start);
    const Real sizes = e_a + e_b + length(query.sweep_b.start - query.sweep_a.start) + paths;
    const Real angles = (std::abs(query.sweep_a.start_angle) + std::abs(query.sweep_a.turn)) * e_a +
                        (std::abs(query.sweep_b.start_angle) + std::abs(query.sweep_b.turn)) * e_b;
    const double reach = static_cast<double>(query.a.radius()) + query.b.radius() + query.target;
    return 0x1p-53L * (24 * sizes + 4 * angles + 16 * reach);
}

// Vertices at a fraction, relative to A's centre at the start.
std::vector<Point> moved(const Shape& shape, const Sweep& sweep, DVec2 origin, Real fraction) {
    const Real angle = sweep.start_angle + fraction * sweep.turn, c = std::cos(angle), s = std::sin(angle);
    const Point displacement{static_cast<Real>(sweep.end.x - sweep.start.x),
                             static_cast<Real>(sweep.end.y - sweep.start.y)};
    const Point start{static_cast<Real>(sweep.start.x - origin.x), static_cast<Real>(sweep.start.y - origin.y)};
    const Point center = start + fraction * displacement;
    std::vector<Point> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const Real x = static_cast<Real>(shape.vertex(i).x) - sweep.local_center.x;
        const Real y = static_cast<Real>(shape.vertex(i).y) - sweep.local_center.y;
        vertices.push_back(center + Point{c * x - s * y, s * x + c * y});
    }
    return vertices;
}

Real gap_at(const Query& query, Real fraction) {
    const DVec2 origin = query.sweep_a.start;
    const Real reach = static_cast<Real>(query.a.radius()) + query.b.radius() + query.target;
    return tumble_test::core_distance(moved(query.a, query.sweep_a, origin, fraction),
                                      moved(query.b, query.sweep_b, origin, fraction)) -
           reach;
}

// No point moves faster relative to one of the other shape (m per motion).
Real top_speed(const Query& query) {
    const DVec2 velocity = (query.sweep_b.end - query.sweep_b.start) - (query.sweep_a.end - query.sweep_a.start);
    return length(velocity) + std::abs(query.sweep_a.turn) * extent_of(query.a, query.sweep_a) +
           std::abs(query.sweep_b.turn) * extent_of(query.b, query.sweep_b);
}

// True if the gap is at least `floor` all over [from, to].
bool is_free(const Query& query, Real speed, Real from, Real to, Real floor) {
    const Real middle = (from + to) / 2, gap = gap_at(query, middle);
    if (gap < floor) return false;
    if (gap - speed * (to - from) / 2 >= floor) return true;
    return is_free(query, speed, from, middle, floor) && is_free(query, speed, middle, to, floor);
}

struct Tally {
    int hits = 0, misses = 0, overlaps = 0, grazes = 0, caps = 0, failures = 0;
};

// Every claim of the header on one query.
bool holds(const Query& query, Tally& tally) {
    const CastResult result = query.impact();
    const Real error = error_of(query), speed = top_speed(query);
    tally.caps += result.reached_cap;
    switch (result.status) {
        case CastStatus::invalid: return false;
        case CastStatus::overlapping: ++tally.overlaps; return gap_at(query, 0) < 0;
        case CastStatus::miss: ++tally.misses; return is_free(query, speed, 0, 1, -4 * error);
        case CastStatus::hit: break;
    }
    ++tally.hits;
    if (!(0.0 <= result.lower && result.lower <= result.fraction && result.fraction <= result.upper &&
          result.upper <= 1.0))
        return false;
    if (!is_free(query, speed, 0, result.lower, -4 * error)) return false;
    if (result.reached_cap) return true;
    if (!(std::abs(gap_at(query, result.fraction)) <= 4 * error)) return false;
    if (!(std::abs(length(result.normal) - 1.0) < 1e-15)) return false;
    // At `upper` the distance is at most the target; only for a graze at the end of the motion this may be undecided.
    const bool is_passed = gap_at(query, result.upper) <= 0;
    if (!is_passed) ++tally.grazes;
    return is_passed || result.upper == 1.0;
}

Sweep random_sweep(Random& random, DVec2 from, DVec2 to, double turn) {
    return {to_float(random.point(0.3)), from, to, random.uniform(-4.0, 4.0), random.uniform(-turn, turn)};
}

Query random_query(Random& random, double turn) {
    Query query;
    query.a = tumble_test::random_shape(random, tumble_test::random_kind(random), 1.0);
    query.b = tumble_test::random_shape(random, tumble_test::random_kind(random), random.uniform(0.3, 3.0));
    const DVec2 center = random.point(random.chance(0.2) ? 1e4 : 1.0);
    query.sweep_a = random_sweep(random, center, center + random.point(0.5), random.chance(0.3) ? 0.0 : turn);
    const DVec2 from = center + random.point(4.0), aim = center + random.point(1.5);
    query.sweep_b =
        random_sweep(random, from, from + random.uniform(0.0, 2.0) * (aim - from), random.chance(0.3) ? 0.0 : turn);
    if (random.chance(0.3)) query.target = random.uniform(0.0, 0.3);
    return query;
}

// Discs that turn about their own centres.
Query random_discs(Random& random, double turn) {
    Query query = random_query(random, turn);
    query.a = tumble_test::random_shape(random, tumble_test::ShapeKind::circle, 1.0);
    query.b = tumble_test::random_shape(random, tumble_test::ShapeKind::circle, random.uniform(0.3, 3.0));
    query.sweep_a.local_center = query.a.vertex(0);
    query.sweep_b.local_center = query.b.vertex(0);
    return query;
}

void check_random(std::uint64_t seed, double turn, std::uint64_t count,
                  Query (*make_query)(Random&, double) = random_query) {
    Tally tally;
    for (std::uint64_t index = 0; index < count; ++index) {
        Random random(seed, index);
        const Query query = make_query(random, turn);
        if (holds(query, tally)) continue;
        ++tally.failures;
        INFO("seed ", seed, " pair ", index, " turn ", turn);
        CHECK(holds(query, tally));
        if (tally.failures == 3) break;
    }
    CHECK(tally.hits > 0.3 * static_cast<double>(count));
    CHECK(tally.misses > 0.1 * static_cast<double>(count));
    CHECK(tally.grazes < 0.01 * static_cast<double>(count));
    CHECK(tally.caps == 0);
}

}  // namespace

TEST_CASE("moving and turning pairs of every kind are never late and never hit without contact") {
    check_random(1, 0.5, tumble_test::pair_count() / 2);
    check_random(2, 3.5, tumble_test::pair_count() / 4);
    check_random(3, 20.0, tumble_test::pair_count() / 8);
    check_random(4, 0.0, tumble_test::pair_count() / 8);
}

TEST_CASE("discs about their own centres are never late, never hit without contact, and take one iteration") {
    check_random(5, 10.0, tumble_test::pair_count() / 4, random_discs);
    const Query query{make_circle(0.5f), make_circle(0.25f), {{}, {}, {}, 0.0, 9.0}, {{}, {4.0, 0.0}, {-4.0, 0.0}}};
    const CastResult result = query.impact();
    CHECK(result.iterations == 1);
    CHECK(std::abs(result.fraction - 3.25 / 8.0) < 1e-14);
    CHECK(std::abs(result.point.x - 0.5) < 1e-14);
}

TEST_CASE("swapping the bodies gives the same fraction and the opposite normal") {
    for (std::uint64_t index = 0; index < tumble_test::pair_count() / 4; ++index) {
        Random random(5, index);
        const Query query = index % 4 == 0 ? random_discs(random, 2.0) : random_query(random, 2.0);
        const CastResult result = query.impact();
        const CastResult swapped = time_of_impact(query.b, query.sweep_b, query.a, query.sweep_a, query.target);
        INFO("pair ", index);
        REQUIRE(result.status == swapped.status);
        REQUIRE(result.fraction == swapped.fraction);
        REQUIRE(result.upper == swapped.upper);
        REQUIRE(result.normal == -swapped.normal);
    }
}

TEST_CASE("scaling lengths by a power of two changes no bit of the fraction") {
    for (std::uint64_t index = 0; index < tumble_test::pair_count() / 4; ++index) {
        Random random(6, index);
        const Query query = index % 4 == 0 ? random_discs(random, 2.0) : random_query(random, 2.0);
        const int exponent = random.integer(-60, 60);
        const double factor = std::ldexp(1.0, exponent);
        Query scaled = query;
        scaled.a = tumble_test::scaled(query.a, exponent);
        scaled.b = tumble_test::scaled(query.b, exponent);
        for (Sweep* sweep : {&scaled.sweep_a, &scaled.sweep_b}) {
            sweep->local_center = static_cast<float>(factor) * sweep->local_center;
            sweep->start = factor * sweep->start;
            sweep->end = factor * sweep->end;
        }
        scaled.target = factor * query.target;
        const CastResult expected = query.impact(), result = scaled.impact();
        INFO("pair ", index);
        REQUIRE(result.status == expected.status);
        REQUIRE(result.fraction == expected.fraction);
        REQUIRE(result.upper == expected.upper);
        REQUIRE(result.normal == expected.normal);
        REQUIRE(result.point == factor * expected.point);
    }
}

TEST_CASE("a rod that turns by more than half a turn hits the post in its path") {
    // The rod reaches 2 m from the pivot. It touches the point at (0, 1) after a quarter of a turn, for any total turn.
    const Shape rod = make_segment({0, 0}, {2, 0}), post = make_circle(0);
    for (const double turn : {2.0, 3.5, 7.0, 40.0, 300.0}) {
        const Sweep rod_sweep{{}, {0, 0}, {0, 0}, 0.0, turn}, post_sweep{{}, {0, 1}, {0, 1}, 0.0, 0.0};
        const CastResult result = time_of_impact(rod, rod_sweep, post, post_sweep);
        INFO("turn ", turn);
        CHECK(result.status == CastStatus::hit);
        CHECK(near(result.fraction * turn, kPi / 2, absolute(1e-12)));
        CHECK(std::abs(result.point.y - 1.0) < 1e-12);
    }
    // In the other direction they touch after three quarters of a turn, 4.71 rad.
    const Sweep back{{}, {0, 0}, {0, 0}, 0.0, -4.0}, post_sweep{{}, {0, 1}, {0, 1}, 0.0, 0.0};
    CHECK(time_of_impact(rod, back, post, post_sweep).status == CastStatus::miss);
}

TEST_CASE("many turns beside a wall are a miss in a bounded number of steps") {
    const Shape rod = make_capsule({-1, 0}, {1, 0}, 0.1f), wall = make_box({1, 10});
    const Sweep still{{}, {2.7, 0}, {2.7, 0}, 0.0, 0.0};
    for (const double turn : {7.0, 30.0, 100.0}) {
        const CastResult result = time_of_impact(rod, {{}, {0, 0}, {1.0, 0}, 0.0, turn}, wall, still);
        CHECK(result.status == CastStatus::miss);
        const CastResult close = time_of_impact(rod, {{}, {0, 0}, {1.09, 0}, 0.0, turn}, wall, still);
        CHECK(close.status == CastStatus::miss);
        CHECK(close.iterations < kMaxImpactSteps);
    }
}

TEST_CASE("a start at the target that recedes, slides or rests is a miss, one that approaches a hit at 0") {
    const Shape box = make_box({2, 2});
    const Sweep floor{{}, {0, 0}, {0, 0}, 0.0, 0.0};
    const auto status = [&](DVec2 displacement, double turn) {
        const DVec2 start{0.25, 2.0};
        return time_of_impact(box, floor, box, {{}, start, start + displacement, 0.0, turn});
    };
    CHECK(status({0, 1}, 0.0).status == CastStatus::miss);
    CHECK(status({0, 2}, 0.3).status == CastStatus::miss);
    CHECK(status({5, 0}, 0.0).status == CastStatus::miss);
    CHECK(status({0, 0}, 0.0).status == CastStatus::miss);
    CHECK(status({0, -1}, 0.0).status == CastStatus::hit);
    CHECK(status({0, -1}, 0.0).fraction == 0.0);
    CHECK(status({0, 0.1}, 0.5).status == CastStatus::hit);  // a corner turns down faster than the box rises
    CHECK(status({0, -0.1}, 0.0).normal == DVec2{0, 1});
}

TEST_CASE("an overlap at the start is overlapping, and input that is not finite is invalid") {
    const Shape box = make_box({2, 2});
    const Sweep still{{}, {0, 0}, {0, 0}, 0.0, 0.0};
    CHECK(time_of_impact(box, still, box, {{}, {1, 0}, {5, 0}, 0.0, 0.0}).status == CastStatus::overlapping);
    CHECK(time_of_impact(box, still, box, {{}, {3, 0}, {5, 0}, 0.0, 0.0}, 1.5).status == CastStatus::overlapping);
    for (const double bad : {kNan, kInfinity, -kInfinity, 1e300}) {
        CHECK(time_of_impact(box, still, box, {{}, {5, 0}, {bad, 0}, 0.0, 0.0}).status == CastStatus::invalid);
        CHECK(time_of_impact(box, still, box, {{}, {5, bad}, {0, 0}, 0.0, 0.0}).status == CastStatus::invalid);
        CHECK(time_of_impact(box, still, box, {{}, {5, 0}, {0, 0}, bad, 0.0}).status == CastStatus::invalid);
        CHECK(time_of_impact(box, still, box, {{}, {5, 0}, {0, 0}, 0.0, bad}).status == CastStatus::invalid);
        CHECK(time_of_impact(box, still, box, still, bad).status == CastStatus::invalid);
    }
    CHECK(time_of_impact(box, still, Shape{}, still).status == CastStatus::invalid);
    CHECK(time_of_impact(box, still, box, {{}, {5, 0}, {5, 0}, 0.0, 0.0}, -1.0).status == CastStatus::invalid);
}
