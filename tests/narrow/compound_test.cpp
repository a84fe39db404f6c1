#include "tumble/compound.hpp"

#include <doctest/doctest.h>

#include <array>
#include <limits>
#include <map>
#include <random>

#include "support/outlines.hpp"
#include "tumble/outline.hpp"

using namespace tumble;

namespace {

using Parts = std::vector<Shape>;

// All pairs in order, the first of equal ones.
CompoundDistance by_brute_force(const Parts& a, const Pose& world_from_a, const Parts& b, const Pose& world_from_b) {
    CompoundDistance best;
    best.nearest.distance = best.lower = best.upper = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            const DistanceResult found = distance(a[i], world_from_a, b[j], world_from_b);
            ++best.queries;
            best.lower = std::min(best.lower, found.lower);
            best.upper = std::min(best.upper, found.upper);
            if (found.distance >= best.nearest.distance) continue;
            best.nearest = found;
            best.part_a = static_cast<std::int32_t>(i);
            best.part_b = static_cast<std::int32_t>(j);
        }
    return best;
}

Shape random_part(std::mt19937_64& random) {
    std::uniform_real_distribution<float> coordinate(-5.0f, 5.0f), size(0.0f, 1.0f);
    const Vec2 center{coordinate(random), coordinate(random)};
    const auto near = [&] { return center + Vec2{size(random), size(random)}; };
    const float radius = random() % 2 ? 0.0f : 0.3f * size(random);
    switch (random() % 3) {
        case 0: return make_circle(size(random), center);
        case 1: return make_capsule(near(), near(), radius);
        default: return make_polygon(std::array<Vec2, 5>{near(), near(), near(), near(), near()}, radius);
    }
}

Parts random_parts(std::size_t count, std::mt19937_64& random) {
    Parts parts;
    for (std::size_t i = 0; i < count; ++i) parts.push_back(random_part(random));
    return parts;
}

Pose random_pose(double reach, std::mt19937_64& random) {
    std::uniform_real_distribution<double> coordinate(-reach, reach), turn(-kPi, kPi);
    return {{coordinate(random), coordinate(random)}, make_rotation(turn(random))};
}

}  // namespace

TEST_CASE("of three circles and two, the nearest pair is found") {
    // Circle 2 at x = 4 and circle 0 of the other compound at x = 8: 8 - 4 - 1 - 1 = 2; every other pair is farther
    // apart.
    const Parts a = {make_circle(1, {0, 0}), make_circle(1, {2, 5}), make_circle(1, {4, 0})};
    const Parts b = {make_circle(1, {0, 0}), make_circle(1, {3, 0})};
    const CompoundDistance result = compound_distance(a, {}, b, {{8, 0}, {}});
    CHECK(result.status == DistanceStatus::separated);
    CHECK(result.part_a == 2);
    CHECK(result.part_b == 0);
    CHECK(result.nearest.distance == 2.0);
    CHECK(result.nearest.point_a == DVec2(5, 0));
    CHECK(result.queries == 1);
    CHECK(compound_overlap(a, {}, b, {{8, 0}, {}}).status == DistanceStatus::separated);
    CHECK(compound_overlap(a, {}, b, {{8, 0}, {}}).queries == 0);
}

TEST_CASE("equal distances go to the lowest indices") {
    const Parts row = {make_box({1, 1}, 0, {6, 0}), make_box({1, 1}, 0, {4, 0}), make_box({1, 1}, 0, {2, 0})};
    const CompoundDistance result = compound_distance(row, {}, row, {{0, 3}, {}});
    CHECK(result.nearest.distance == 2.0);
    CHECK(result.part_a == 0);
    CHECK(result.part_b == 0);
}

TEST_CASE("the deepest pair is the answer inside") {
    // Circle 1 has its center on the upper edge: depth 1. Circle 0 is centred 0.5 above it: depth 0.5.
    const Parts circles = {make_circle(1, {0, 2.5f}), make_circle(1, {3, 2})};
    const Parts box = {make_box({10, 4})};
    const CompoundDistance result = compound_distance(circles, {}, box, {});
    CHECK(result.status == DistanceStatus::overlapping);
    CHECK(result.part_a == 1);
    CHECK(result.nearest.distance == -1.0);
}

TEST_CASE("compounds without parts or with an invalid one are invalid") {
    const Parts circle = {make_circle(1)}, none;
    const Parts broken = {make_circle(1), Shape{}};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK(compound_distance(circle, {}, none, {}).status == DistanceStatus::invalid);
    CHECK(compound_distance(none, {}, none, {}).part_a == -1);
    CHECK(std::isnan(compound_distance(circle, {}, broken, {}).nearest.distance));
    CHECK(compound_overlap(broken, {}, circle, {}).status == DistanceStatus::invalid);
    CHECK(compound_distance(circle, {{0, 0}, {nan, 0}}, circle, {}).status == DistanceStatus::invalid);
    CHECK(compound_overlap(circle, {{1e308, 0}, {}}, circle, {{-1e308, 0}, {}}).status == DistanceStatus::invalid);
}

TEST_CASE("random compounds have the bits of a search over all pairs, with less than a fifth of its queries") {
    std::mt19937_64 random(11);
    std::map<DistanceStatus, int> seen;
    double queries = 0, pairs = 0;
    for (int sample = 0; sample < 3000; ++sample) {
        const Parts a = random_parts(1 + random() % 12, random), b = random_parts(1 + random() % 12, random);
        Pose pose_a = random_pose(3.0, random), pose_b = random_pose(3.0, random);
        if (sample % 4 == 0) {  // far from the origin
            pose_a.position += DVec2(1e6, -3e5);
            pose_b.position += DVec2(1e6, -3e5);
        }
        const CompoundDistance found = compound_distance(a, pose_a, b, pose_b),
                               all = by_brute_force(a, pose_a, b, pose_b);
        REQUIRE(found.nearest.distance == all.nearest.distance);
        REQUIRE(found.part_a == all.part_a);
        REQUIRE(found.part_b == all.part_b);
        REQUIRE(found.nearest.point_a == all.nearest.point_a);
        REQUIRE(found.nearest.normal == all.nearest.normal);
        REQUIRE(found.lower == all.lower);
        REQUIRE(found.upper == all.upper);
        REQUIRE(found.status == all.nearest.status);
        const CompoundOverlap overlap = compound_overlap(a, pose_a, b, pose_b);
        REQUIRE(overlap.status == found.status);
        REQUIRE(overlap.queries <= all.queries);
        REQUIRE((overlap.part_a >= 0) == (found.status != DistanceStatus::separated));
        ++seen[found.status];
        queries += found.queries;
        pairs += all.queries;
    }
    CHECK(seen[DistanceStatus::separated] > 900);
    CHECK(seen[DistanceStatus::overlapping] > 900);
    MESSAGE("distance calls: " << queries << " of " << pairs);
    CHECK(queries < 0.2 * pairs);
}

TEST_CASE("rounding of the bounds loses none of the equal distances of flush parts on large ones") {
    // Boxes of 1 cm on a ground of 2 km pieces whose surfaces touch: all distances are 0 or within E of it.
    Parts ground, crates;
    for (int i = -3; i < 3; ++i) ground.push_back(make_box({2000, 100}, 0, {2000.0f * static_cast<float>(i), -50}));
    for (int i = 0; i < 20; ++i)
        crates.push_back(make_box({0.01f, 0.01f}, 0, {static_cast<float>(i - 10) * 313.7f, 0.005f}));
    for (int sample = 0; sample < 200; ++sample) {
        const Pose pose{{0.1 * static_cast<double>(sample), 1e-12 * static_cast<double>(sample % 3)}, {}};
        const CompoundDistance found = compound_distance(ground, {}, crates, pose),
                               all = by_brute_force(ground, {}, crates, pose);
        REQUIRE(found.nearest.distance == all.nearest.distance);
        REQUIRE(found.part_a == all.part_a);
        REQUIRE(found.part_b == all.part_b);
    }
}

TEST_CASE("swapping the compounds changes neither the distance nor its bounds") {
    std::mt19937_64 random(13);
    for (int sample = 0; sample < 300; ++sample) {
        const Parts a = random_parts(6, random), b = random_parts(9, random);
        const Pose pose_a = random_pose(3.0, random), pose_b = random_pose(3.0, random);
        const CompoundDistance ab = compound_distance(a, pose_a, b, pose_b),
                               ba = compound_distance(b, pose_b, a, pose_a);
        CHECK(ab.nearest.distance == ba.nearest.distance);
        CHECK(ab.lower == ba.lower);
        CHECK(ab.upper == ba.upper);
    }
}

TEST_CASE("of all pairs of two large decomposed outlines less than a thousandth is queried") {
    std::mt19937_64 random(14);
    const Parts a = decompose_outline(test::star(2000, 10000.0f, random));
    const Parts b = decompose_outline(test::star(2000, 10000.0f, random));
    const CompoundDistance found = compound_distance(a, {}, b, {{21000.0, 500.0}, make_rotation(1.0)});
    const CompoundDistance all = by_brute_force(a, {}, b, {{21000.0, 500.0}, make_rotation(1.0)});
    CHECK(found.nearest.distance == all.nearest.distance);
    CHECK(found.part_a == all.part_a);
    CHECK(found.part_b == all.part_b);
    MESSAGE("distance calls: " << found.queries << " of " << all.queries);
    CHECK(found.queries < all.queries / 1000);
}

namespace {

// The first of all pairs in order; `overlapping` if any is.
template <class Cast>
CompoundCast first_by_brute_force(std::size_t parts_a, std::size_t parts_b, Cast cast) {
    CompoundCast best;
    best.first.status = CastStatus::miss;
    best.first.fraction = 2.0;
    for (std::size_t i = 0; i < parts_a; ++i)
        for (std::size_t j = 0; j < parts_b; ++j) {
            const CastResult found = cast(i, j);
            ++best.queries;
            const bool is_earlier = found.status == CastStatus::hit && found.fraction < best.first.fraction;
            const bool overlaps = found.status == CastStatus::overlapping;
            if (best.first.status == CastStatus::overlapping || !(overlaps || is_earlier)) continue;
            best.first = found;
            best.part_a = static_cast<std::int32_t>(i);
            best.part_b = static_cast<std::int32_t>(j);
        }
    return best;
}

struct CastTally {
    int hits = 0, misses = 0, overlaps = 0;
    long queries = 0, pairs = 0;

    void compare(const CompoundCast& found, const CompoundCast& expected) {
        queries += found.queries;
        pairs += expected.queries;
        REQUIRE(found.first.status == expected.first.status);
        hits += found.first.status == CastStatus::hit;
        misses += found.first.status == CastStatus::miss;
        overlaps += found.first.status == CastStatus::overlapping;
        if (found.first.status != CastStatus::hit) return;
        REQUIRE(found.first.fraction == expected.first.fraction);
        REQUIRE(found.part_a == expected.part_a);
        REQUIRE(found.part_b == expected.part_b);
        REQUIRE(found.first.point == expected.first.point);
        REQUIRE(found.first.normal == expected.first.normal);
    }

    void check_counts() const {
        CHECK(hits > 100);
        CHECK(misses > 100);
        CHECK(overlaps > 5);
        CHECK(queries < pairs / 2);
    }
};

}  // namespace

TEST_CASE("casts of compounds give the bits of the first of all pairs, from fewer queries") {
    CastTally rays, casts, impacts;
    for (unsigned sample = 0; sample < 600; ++sample) {
        std::mt19937_64 random(sample);
        const Parts a = random_parts(1 + sample % 20, random), b = random_parts(1 + sample % 7, random);
        const Pose pose_a = random_pose(100.0, random);
        Pose pose_b = random_pose(9.0, random);
        pose_b.position += pose_a.position;
        const DVec2 aim = random_pose(7.0, random).position,
                    displacement = 1.2 * (pose_a.position + aim - pose_b.position);
        const double target = sample % 3 ? 0.0 : 0.1;
        rays.compare(compound_cast_ray(a, pose_a, pose_b.position, displacement),
                     first_by_brute_force(a.size(), 1, [&](std::size_t i, std::size_t) {
                         return cast_ray(a[i], pose_a, pose_b.position, displacement);
                     }));
        casts.compare(compound_cast_shape(a, pose_a, b, pose_b, displacement, target),
                      first_by_brute_force(a.size(), b.size(), [&](std::size_t i, std::size_t j) {
                          return cast_shape(a[i], pose_a, b[j], pose_b, displacement, target);
                      }));
        const Sweep sweep_a{
            {0.5f, 0.25f}, pose_a.position, pose_a.position + 0.1 * displacement, angle(pose_a.rotation), 0.5};
        const Sweep sweep_b{{-0.5f, 1.0f},
                            pose_b.position,
                            pose_b.position + displacement,
                            angle(pose_b.rotation),
                            sample % 2 ? -1.5 : 0.0};
        impacts.compare(compound_time_of_impact(a, sweep_a, b, sweep_b, target),
                        first_by_brute_force(a.size(), b.size(), [&](std::size_t i, std::size_t j) {
                            return time_of_impact(a[i], sweep_a, b[j], sweep_b, target);
                        }));
    }
    rays.check_counts();
    casts.check_counts();
    impacts.check_counts();
}

TEST_CASE("casts of no parts, and of parts or motions that are not finite, are invalid") {
    const Parts one = {make_circle(1)}, none, bad = {make_circle(1), Shape{}};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(compound_cast_ray(none, {}, {-5, 0}, {9, 0}).first.status == CastStatus::invalid);
    CHECK(compound_cast_ray(bad, {}, {-5, 0}, {9, 0}).first.status == CastStatus::invalid);
    CHECK(compound_cast_ray(one, {}, {-5, 0}, {nan, 0}).first.status == CastStatus::invalid);
    CHECK(compound_cast_ray(one, {}, {-5, 0}, {9, 0}).first.fraction == 4.0 / 9.0);
    CHECK(compound_cast_shape(one, {}, bad, {{5, 0}, {}}, {-9, 0}).first.status == CastStatus::invalid);
    CHECK(compound_cast_shape(one, {}, one, {{5, 0}, {}}, {-9, 0}, -1.0).first.status == CastStatus::invalid);
    const Sweep still{{}, {}, {}, 0.0, 0.0}, coming{{}, {5, 0}, {-5, 0}, 0.0, 1.0}, mad{{}, {5, 0}, {nan, 0}, 0.0, 1.0};
    CHECK(compound_time_of_impact(one, still, one, coming).first.status == CastStatus::hit);
    CHECK(compound_time_of_impact(one, still, one, mad).first.status == CastStatus::invalid);
    CHECK(compound_time_of_impact(one, still, one, coming, -1.0).first.status == CastStatus::invalid);
    // Also if the motion ends so far away that no pair of parts is queried.
    const Sweep short_of{{}, {50, 0}, {45, 0}, 0.0, 0.0};
    CHECK(compound_time_of_impact(one, still, one, short_of).first.status == CastStatus::miss);
    CHECK(compound_time_of_impact(one, still, one, short_of, -1.0).first.status == CastStatus::invalid);
    CHECK(compound_time_of_impact(none, still, one, coming).first.status == CastStatus::invalid);
}
