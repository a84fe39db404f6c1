// The rows of the table of hard families, one list per subject; pair_families() concatenates them.
#pragma once

#include <span>

#include "reference/families/pair_families.hpp"
#include "reference/query/random.hpp"

namespace tumble::reference {

std::span<const PairFamily> random_families();
std::span<const PairFamily> gap_families();
std::span<const PairFamily> touching_families();
std::span<const PairFamily> thin_families();
std::span<const PairFamily> scale_families();
std::span<const PairFamily> extreme_families();
std::span<const PairFamily> symmetric_families();
std::span<const PairFamily> radius_families();
std::span<const PairFamily> search_families();

// Makes a generator of a function that draws from one random stream.
template <PairQuery (*Make)(Random&)>
PairQuery seeded(std::uint64_t seed, std::uint64_t index) {
    Random random(seed, index);
    return Make(random);
}

}  // namespace tumble::reference
