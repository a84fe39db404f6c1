// What tests ask of answers to distance queries, and how many pairs they try.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "reference/pair_families.hpp"
#include "support/pair_count.hpp"
#include "tumble/distance.hpp"

namespace tumble_test {

// Of large polygons a fiftieth.
inline std::uint64_t pairs_of(const tumble::reference::PairFamily& family, std::uint64_t usual) {
    const std::uint64_t all = pair_count(usual);
    return family.kind == tumble::reference::FamilyKind::large ? std::max<std::uint64_t>(all / 50, 1) : all;
}

inline bool is_status_right(tumble::DistanceStatus status, int exact_sign) {
    return (status == tumble::DistanceStatus::separated && exact_sign > 0) ||
           (status == tumble::DistanceStatus::overlapping && exact_sign < 0) || status == tumble::DistanceStatus::touching;
}

// Bit for bit, so that NaN equals itself and 0 is not -0.
inline bool have_same_bits(double x, double y) { return std::memcmp(&x, &y, sizeof x) == 0; }
inline bool have_same_bits(tumble::DVec2 p, tumble::DVec2 q) { return have_same_bits(p.x, q.x) && have_same_bits(p.y, q.y); }

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
