// The hard families: seeded generators of the pairs on which distance algorithms fail, in one table.
//
// Tests, the parity run and the bench draw from the same table, so that a failure found by one is a row of the others.
// Every family makes its pair number `index` from (seed, index) alone, the same bits on every platform.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "reference/query/pair_query.hpp"

namespace tumble::reference {

// What an answer to a pair of the family is checked against.
enum class FamilyKind : std::uint8_t {
    exact,    // the exact distance
    large,    // more than 64 vertices: the answer's certificate, checked exactly
    invalid,  // not finite, or beyond what double can square: the answer must say so
};

struct PairFamily {
    std::string_view name;
    std::string_view description;
    PairQuery (*generate)(std::uint64_t seed, std::uint64_t index);
    double share = 1.0;  // of the pairs in a mixed run, relative to the others; small where a pair is expensive
    FamilyKind kind = FamilyKind::exact;
};

std::span<const PairFamily> pair_families();

// Null if there is none of that name.
const PairFamily* find_pair_family(std::string_view name);

// Steps of one trajectory in the family "trajectory": pairs k * kTrajectorySteps to (k + 1) * kTrajectorySteps - 1 are
// the same two shapes moving smoothly.
inline constexpr std::uint64_t kTrajectorySteps = 64;

// Known failures of other libraries and engines, each a single case.
struct RegressionCase {
    std::string_view name;
    std::string_view description;
    PairQuery query;
    int expected_sign = 0;  // of the exact signed distance
};

std::span<const RegressionCase> regression_cases();

}  // namespace tumble::reference
