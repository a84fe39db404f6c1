// The quick way through a line of `distance --stdin`: one convex shape each, spelled as scene files do, nothing
// unusual.
//
// What a plain line means is decided elsewhere, by make_exact_shapes() and the strict reader; this one only recognizes the
// lines that need no judgement, in a ninth of the time. It has no error messages: whatever it does not recognize, right
// or wrong, is the strict reader's.
#pragma once

#include <optional>
#include <string_view>

#include "tools/query/distance_query.hpp"

namespace tumble::tools {

// Nothing if the line is not plain.
std::optional<DistanceQuery> read_plain_query(std::string_view line);

}  // namespace tumble::tools
