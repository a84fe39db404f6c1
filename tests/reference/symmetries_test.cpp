// Symmetries that hold bit for bit, on the hard families too: swapping the shapes, scaling by powers of two, exact
// translations, quarter turns, warm starts.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "reference/exact/exact_distance.hpp"
#include "reference/families/pair_families.hpp"
#include "reference/query/random.hpp"
#include "tumble/distance.hpp"

using namespace tumble;
using namespace tumble::reference;

namespace {

constexpr std::uint64_t kSeed = 411;

DistanceResult measure(const PairQuery& q, SimplexCache* cache = nullptr) {
    return distance(q.a, q.pose_a, q.b, q.pose_b, cache);
}

bool same_numbers(const DistanceResult& one, const DistanceResult& other) {
    return one.distance == other.distance && one.lower == other.lower && one.upper == other.upper &&
           one.status == other.status;
}

// Calls check(query, answer, random) for pairs of every family of valid input.
template <class Check>
void for_each_pair(Check check) {
    for (const PairFamily& family : pair_families()) {
        if (family.kind == FamilyKind::invalid) continue;
        const std::uint64_t pairs = family.kind == FamilyKind::large ? 20 : family.share < 0.1 ? 200 : 2000;
        CAPTURE(family.name);
        for (std::uint64_t index = 0; index < pairs; ++index) {
            const PairQuery query = family.generate(kSeed, index);
            Random random(~kSeed, index);
            CAPTURE(index);
            check(query, measure(query), random);
        }
    }
}

PairQuery quarter_turned(PairQuery q) {
    for (Pose* pose : {&q.pose_a, &q.pose_b}) *pose = {perp(pose->position), {-pose->rotation.s, pose->rotation.c}};
    return q;
}

// True if 2^exponent times the number is exact and in a range in which products of four such lengths neither overflow
// nor underflow.
bool scales_exactly(double number, int exponent) {
    const double scaled = std::ldexp(number, exponent);
    return number == 0.0 || (std::abs(scaled) > 0x1p-200 && std::abs(scaled) < 0x1p200 && std::abs(number) > 0x1p-200);
}
bool scales_exactly(float number, int exponent) {
    const float scaled = std::ldexp(number, exponent);
    return number == 0.0f || (std::isnormal(number) && std::isnormal(scaled));
}

bool scales_exactly(const Shape& shape, int exponent) {
    const auto scales = [exponent](float number) { return scales_exactly(number, exponent); };
    return scales(shape.radius()) && std::ranges::all_of(shape.x(), scales) && std::ranges::all_of(shape.y(), scales);
}

Shape scaled(const Shape& shape, int exponent) {
    std::vector<Vec2> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i)
        vertices.push_back({std::ldexp(shape.vertex(i).x, exponent), std::ldexp(shape.vertex(i).y, exponent)});
    return Shape::from_raw(vertices, std::ldexp(shape.radius(), exponent));
}

DVec2 scaled(DVec2 v, int exponent) { return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent)}; }

// The positions rounded to a grid that is coarse enough for shifts by 2^20 of its steps to be exact.
double snap_to_grid(PairQuery& q) {
    const double largest = std::max({std::abs(q.pose_a.position.x), std::abs(q.pose_a.position.y),
                                     std::abs(q.pose_b.position.x), std::abs(q.pose_b.position.y), 0x1p-900});
    const double step = std::ldexp(1.0, std::ilogb(largest) - 30);
    for (Pose* pose : {&q.pose_a, &q.pose_b})
        pose->position = {std::nearbyint(pose->position.x / step) * step,
                          std::nearbyint(pose->position.y / step) * step};
    return step;
}

// Families of pairs whose closest feature is unique by more than rounding.
constexpr std::array<std::string_view, 13> kClearFamilies{
    "random",    "random_scale", "random_apart", "random_many_vertices", "near_gap", "near_overlap",
    "far_1km",   "far_16km",     "far_100km",    "drifted_rotations",    "scales",   "touching_circles",
    "trajectory"};

}  // namespace

TEST_CASE("on every family, swapping the shapes changes no number") {
    for_each_pair([](const PairQuery& query, const DistanceResult& answer, Random&) {
        CHECK(same_numbers(answer, measure(query.swapped())));
    });
}

TEST_CASE("on every family, quarter turns change no number") {
    for_each_pair([](const PairQuery& query, const DistanceResult& answer, Random&) {
        CHECK(same_numbers(answer, measure(quarter_turned(query))));
    });
}

TEST_CASE("on every family, powers of two scale every length bit for bit") {
    int scaled_pairs = 0;
    for_each_pair([&](const PairQuery& query, const DistanceResult& answer, Random& random) {
        const int k = random.integer(-60, 60);
        if (!scales_exactly(query.a, k) || !scales_exactly(query.b, k)) return;
        for (const DVec2 position : {query.pose_a.position, query.pose_b.position})
            if (!scales_exactly(position.x, k) || !scales_exactly(position.y, k)) return;
        ++scaled_pairs;
        const DistanceResult grown = measure({scaled(query.a, k),
                                              scaled(query.b, k),
                                              {scaled(query.pose_a.position, k), query.pose_a.rotation},
                                              {scaled(query.pose_b.position, k), query.pose_b.rotation}});
        CHECK(std::ldexp(answer.distance, k) == grown.distance);
        CHECK(std::ldexp(answer.lower, k) == grown.lower);
        CHECK(std::ldexp(answer.upper, k) == grown.upper);
        CHECK(answer.status == grown.status);
        CHECK(answer.normal == grown.normal);
    });
    CHECK(scaled_pairs > 40000);
}

TEST_CASE("on every family, exact translations change no number") {
    for_each_pair([](PairQuery query, const DistanceResult&, Random& random) {
        const double step = snap_to_grid(query);
        PairQuery moved = query;
        const DVec2 shift{step * random.integer(-1 << 20, 1 << 20), step * random.integer(-1 << 20, 1 << 20)};
        moved.pose_a.position += shift;
        moved.pose_b.position += shift;
        const DistanceResult answer = measure(query), after = measure(moved);
        if (answer.status == DistanceStatus::invalid) return;  // snapped out of range
        CHECK(same_numbers(answer, after));
        CHECK(answer.normal == after.normal);
    });
}

TEST_CASE("warm answers have the bits of cold ones if a single pair is closest: stale, random and foreign caches") {
    int unique = 0;
    for (const std::string_view name : kClearFamilies) {
        const PairFamily* family = find_pair_family(name);
        REQUIRE(family != nullptr);
        CAPTURE(name);
        SimplexCache carried;  // from pair to pair: stale along a trajectory, foreign elsewhere, often out of range
        for (std::uint64_t index = 0; index < 1000; ++index) {
            CAPTURE(index);
            const PairQuery query = family->generate(kSeed, index);
            const DistanceResult cold = measure(query);
            Random random(kSeed, index);
            SimplexCache drawn;
            drawn.count = static_cast<std::uint8_t>(random.integer(0, 4));
            for (VertexPair& pair : drawn.pairs)
                pair = {static_cast<std::uint16_t>(random.integer(0, query.a.vertex_count())),
                        static_cast<std::uint16_t>(random.integer(0, query.b.vertex_count()))};
            const DistanceResult after_carried = measure(query, &carried), after_drawn = measure(query, &drawn);
            const ExactDistance exact = ExactDistance(query.without_radii());
            if (exact.sign() <= 0 || !exact.has_unique_pair()) continue;
            ++unique;
            CHECK(same_numbers(cold, after_carried));
            CHECK(same_numbers(cold, after_drawn));
            CHECK(cold.normal == after_carried.normal);
            CHECK(cold.point_a == after_drawn.point_a);
            CHECK(cold.point_b == after_drawn.point_b);
        }
    }
    CHECK(unique > 6000);
}
