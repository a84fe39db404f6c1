// Checks of answers to distance queries, and the number of pairs to try.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "narrow/cores/error_bound.hpp"
#include "reference/exact/exact_distance.hpp"
#include "reference/families/pair_families.hpp"
#include "reference/query/random.hpp"
#include "support/pair_count.hpp"
#include "tumble/distance.hpp"

namespace tumble_test {

// For large polygons a fiftieth.
inline std::uint64_t pairs_of(const tumble::reference::PairFamily& family, std::uint64_t usual) {
    const std::uint64_t all = pair_count(usual);
    return family.kind == tumble::reference::FamilyKind::large ? std::max<std::uint64_t>(all / 50, 1) : all;
}

// A vertex of each shape; 0 for a shape without vertices.
inline tumble::VertexPair random_vertices(tumble::reference::Random& random,
                                          const tumble::reference::PairQuery& query) {
    const auto index = [&](const tumble::Shape& shape) {
        return static_cast<std::uint16_t>(random.integer(0, std::max(shape.vertex_count(), 1) - 1));
    };
    tumble::VertexPair pair;
    pair.a = index(query.a);
    pair.b = index(query.b);
    return pair;
}

inline bool is_status_right(tumble::DistanceStatus status, const tumble::reference::ExactDistance& exact) {
    switch (status) {
        case tumble::DistanceStatus::separated: return exact.sign() > 0;
        case tumble::DistanceStatus::overlapping: return exact.sign() < 0;
        case tumble::DistanceStatus::touching: return true;
        case tumble::DistanceStatus::invalid: break;
    }
    return false;
}

inline double core_error_bound(const tumble::reference::PairQuery& query) {
    return tumble::error_bound(tumble::make_core_pair(query.a, query.pose_a, query.b, query.pose_b));
}

// How well the bounds of an answer enclose the exact distance. near: tightly; loose: wider than rounding usually makes
// them; wrong: not at all, or wider than rounding can make them.
enum class BoundsFit { near, loose, wrong };

// Near is E for the error of what was computed, E for its allowance, the same for the subtraction of the radii, and
// twice that for answers found by the last repair. Bounds of [-1, 1] would pass every other check. The direction from a
// vertex at the distance |v| is off by E / |v|: another vertex, at most 2 (RA + RB) aside, may stand out by as much
// along it and loosen the lower bound; 13 E were seen.
inline BoundsFit fit_of(const tumble::reference::PairQuery& query, const tumble::DistanceResult& answer,
                        const tumble::reference::ExactDistance& exact) {
    const bool is_between = answer.lower <= answer.distance && answer.distance <= answer.upper;
    if (!is_between || exact.compare(answer.lower) < 0 || exact.compare(answer.upper) > 0) return BoundsFit::wrong;
    const double radii = double{query.a.radius()} + double{query.b.radius()}, core_distance = answer.distance + radii;
    const double error = core_error_bound(query);
    const double slack = 4.0 * (error + 4.0 * tumble::kUnitRoundoff * (radii + std::abs(core_distance)));
    const auto reaches_down_by = [&](double margin) { return exact.compare(answer.lower, margin) > 0; };
    const bool is_above = exact.compare(answer.upper, -slack) >= 0;
    if (is_above && !reaches_down_by(slack)) return BoundsFit::near;
    const double scale = error / (16.0 * tumble::kUnitRoundoff);
    const double aside = 2.0 * scale * error / std::max(std::abs(core_distance), error);
    return is_above && !reaches_down_by(slack + aside) ? BoundsFit::loose : BoundsFit::wrong;
}

// Bit for bit, so that NaN equals itself and 0 is not -0.
inline bool have_same_bits(double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
}
inline bool have_same_bits(tumble::DVec2 p, tumble::DVec2 q) {
    return have_same_bits(p.x, q.x) && have_same_bits(p.y, q.y);
}

inline bool have_same_bits(const tumble::DistanceResult& one, const tumble::DistanceResult& other) {
    const tumble::Certificate &p = one.certificate, &q = other.certificate;
    return have_same_bits(one.distance, other.distance) && have_same_bits(one.lower, other.lower) &&
           have_same_bits(one.upper, other.upper) && have_same_bits(one.point_a, other.point_a) &&
           have_same_bits(one.point_b, other.point_b) && have_same_bits(one.normal, other.normal) &&
           have_same_bits(p.direction, q.direction) && p.pairs == q.pairs && p.pair_count == q.pair_count &&
           p.cores_overlap == q.cores_overlap && one.status == other.status && one.iterations == other.iterations &&
           one.reached_cap == other.reached_cap;
}

}  // namespace tumble_test
