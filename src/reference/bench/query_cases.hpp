// The queries that are timed in both engines, each from two world poses to the full answer.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace tumble::reference {

// Runs all queries of a case once, in one engine. The returned sum of the answers keeps the compiler from removing
// queries.
using QueryRun = std::function<double()>;

struct QueryRuns {
    QueryRun tumble;
    QueryRun box2d;
    QueryRun box2d_v3{};  // empty: not timed for this case, or not in this build
};

struct QueryCase {
    std::string name;
    std::function<QueryRuns(int pairs, std::uint64_t seed)> make;  // the runs own their pairs
};

// The table: distances (cold, warm and in batches) by kind of shape and gap, manifolds, times of impact, rays. Warm:
// the cache of each pair is kept from one run to the next, while nothing moves.
std::vector<QueryCase> query_cases();

}  // namespace tumble::reference
