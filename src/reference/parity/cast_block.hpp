// Queries both engines with a block of moving pairs and judges the answers.
#pragma once

#include "reference/families/cast_families.hpp"
#include "reference/parity/parity.hpp"

namespace tumble::reference {

// Moving pairs [begin, end) of a family. A pair is ill-conditioned if the engines answer differently and neither is
// wrong. Errors are gaps at the fractions of hits (m).
ParityRow compare_cast_block(const CastFamily& family, std::uint64_t begin, std::uint64_t end,
                             const ParityOptions& options);

}  // namespace tumble::reference
