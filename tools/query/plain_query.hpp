// The fast path of `distance --stdin`: recognizes the common form of a query and reads it nine times faster than the
// strict reader.
//
// A plain line has two convex shapes as in scene files, numbers of usual size, no escapes and no duplicate keys. For
// such a line both readers give the same query. Every other line, valid or not, is left to the strict reader, which
// writes all error messages.
#pragma once

#include <optional>
#include <string_view>

#include "tools/query/distance_query.hpp"

namespace tumble::tools {

// Empty if the line is not plain.
std::optional<DistanceQuery> read_plain_query(std::string_view line);

}  // namespace tumble::tools
