// Times narrow-phase queries of tumble and of Box2D.
#pragma once

#include <cstdint>
#include <string>

#include "reference/bench/query_cases.hpp"

namespace tumble::tools {

struct QueryBenchOptions {
    int pairs = 65536;  // so many that the branch predictor cannot learn the outcomes
    int runs = 5;       // of each engine, alternating
    std::uint64_t seed = 1;
};

struct QueryBenchResult {
    std::string name;
    double tumble_ns = 0.0;  // CPU time per query, median of the runs
    double box2d_ns = 0.0;
    double box2d_v3_ns = 0.0;  // 0: not timed
    double ratio() const { return box2d_ns / tumble_ns; }
};

QueryBenchResult bench_queries(const reference::QueryCase& query_case, const QueryBenchOptions& options);

}  // namespace tumble::tools
