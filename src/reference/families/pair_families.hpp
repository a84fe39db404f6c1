// The hard families: seeded generators of pairs on which distance algorithms fail, in one table.
//
// Tests and the parity run share the table. A family generates pair number `index` from (seed, index) alone, with the
// same bits on every platform.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "reference/query/pair_query.hpp"

namespace tumble::reference {

// What an answer to a pair of the family is checked against.
enum class FamilyKind : std::uint8_t {
    exact,    // the exact distance
    large,    // the certificate of the answer, checked exactly: more than 64 vertices
    invalid,  // the status `invalid`: input that is not finite, or too large to square in double
};

struct PairFamily {
    std::string_view name;
    std::string_view description;
    PairQuery (*generate)(std::uint64_t seed, std::uint64_t index);
    double share = 1.0;  // of the pairs in a mixed run, relative to the other families; small if a pair is expensive
    FamilyKind kind = FamilyKind::exact;
};

std::span<const PairFamily> pair_families();

// Null if there is none of that name.
const PairFamily* find_pair_family(std::string_view name);

// Steps per trajectory in the family "trajectory": pairs k * kTrajectorySteps to (k + 1) * kTrajectorySteps - 1 are the
// same two shapes in smooth motion.
inline constexpr std::uint64_t kTrajectorySteps = 64;

// Known failures of other libraries and engines, one case each.
struct RegressionCase {
    std::string_view name;
    std::string_view description;
    PairQuery query;
    int expected_sign = 0;  // of the exact signed distance
};

std::span<const RegressionCase> regression_cases();

}  // namespace tumble::reference
