// A block of pairs, asked of both engines and judged.
#pragma once

#include <span>

#include "reference/parity/judge.hpp"

namespace tumble::reference {

// Pairs [begin, end) of a family.
ParityRow compare_family_block(const PairFamily& family, std::uint64_t begin, std::uint64_t end,
                               const ParityOptions& options);

// Queries that come from elsewhere, the first of them with the given index.
ParityRow compare_queries(std::span<const PairQuery> queries, std::uint64_t first_index, const ParityOptions& options);

}  // namespace tumble::reference
