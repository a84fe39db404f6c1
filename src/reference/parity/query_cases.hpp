// The queries that both engines are timed at, each from two world poses to its full answer.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace tumble::reference {

// One engine's queries of a case: asks all of them once. The sum of what they answer keeps the compiler from dropping
// any.
using QueryRun = std::function<double()>;

struct QueryRuns {
    QueryRun tumble;
    QueryRun box2d;
};

// Warm: each pair's cache is kept from one run to the next, while nothing moves.
struct QueryCase {
    std::string name;
    std::function<QueryRuns(int pairs, std::uint64_t seed)> make;  // the pairs of both engines live as long as the runs
};

// Distances cold, warm and in batches by kind and nearness, manifolds, times of impact of approaching bodies, rays that
// hit.
std::vector<QueryCase> query_cases();

}  // namespace tumble::reference
