// The fast reader of a line of `distance --stdin`: two convex shapes in the spelling of scene files, nothing unusual.
//
// It takes a ninth of the time of the strict reader and has no error messages: a line that it does not recognize, right
// or wrong, goes to the strict reader. Both make shapes by make_exact_shapes(), so they agree bit for bit.
#pragma once

#include <optional>
#include <string_view>

#include "tools/query/distance_query.hpp"

namespace tumble::tools {

// Nothing if the line is not plain.
std::optional<DistanceQuery> read_plain_query(std::string_view line);

}  // namespace tumble::tools
