// Queries both engines with a block of pairs and judges the answers.
#pragma once

#include <span>

#include "reference/parity/judge.hpp"

namespace tumble::reference {

// Pairs [begin, end) of a family.
ParityRow compare_family_block(const PairFamily& family, std::uint64_t begin, std::uint64_t end,
                               const ParityOptions& options);

// Queries of the caller; the first one has the index `first_index`.
ParityRow compare_queries(std::span<const PairQuery> queries, std::uint64_t first_index, const ParityOptions& options);

}  // namespace tumble::reference
