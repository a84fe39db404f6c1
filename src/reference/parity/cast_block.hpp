// A block of moving pairs, asked of both engines and judged.
#pragma once

#include "reference/families/cast_families.hpp"
#include "reference/parity/parity.hpp"

namespace tumble::reference {

// Moving pairs [begin, end) of a family, each judged; where the engines answer differently and neither is wrong, the
// input is ill-conditioned. Errors are gaps at the fractions of hits (m).
ParityRow compare_cast_block(const CastFamily& family, std::uint64_t begin, std::uint64_t end,
                             const ParityOptions& options);

}  // namespace tumble::reference
