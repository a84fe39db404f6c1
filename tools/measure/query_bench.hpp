// Times the queries of the narrow phase beside Box2D's.
#pragma once

#include <cstdint>
#include <string>

#include "reference/bench/query_cases.hpp"

namespace tumble::tools {

struct QueryBenchOptions {
    int pairs = 65536;  // so many that neither engine's branches are learnt by heart
    int runs = 5;       // of each engine, taking turns
    std::uint64_t seed = 1;
};

struct QueryBenchResult {
    std::string name;
    double tumble_ns = 0.0;  // CPU time of a query, median of the runs
    double box2d_ns = 0.0;
    double ratio() const { return box2d_ns / tumble_ns; }
};

QueryBenchResult bench_queries(const reference::QueryCase& query_case, const QueryBenchOptions& options);

}  // namespace tumble::tools
