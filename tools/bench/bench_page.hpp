// The measurements of `tumble bench` as a page for the browser.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/bench/growth_bench.hpp"
#include "tools/bench/query_bench.hpp"
#include "tools/bench/step_bench.hpp"
#include "tools/bench/worlds_bench.hpp"

namespace tumble::tools {

struct BenchResult {
    std::vector<QueryBenchResult> queries;
    std::vector<StepBenchResult> steps;
    std::optional<WorldsBenchResult> worlds{};
    std::vector<GrowthResult> growth{};
    StepBenchOptions options{};
    int world_count = 0;  // of `worlds`
};

// A self-contained HTML document: for queries and for scenes a plot of the ratios and a table; the stages of the steps
// as stacked bars; the growth of time and memory with the number of bodies.
std::string bench_page(const BenchResult& result);

}  // namespace tumble::tools
