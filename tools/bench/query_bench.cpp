#include "tools/bench/query_bench.hpp"

#include <vector>

#include "tools/measure/cpu_clock.hpp"
#include "tools/measure/median.hpp"

namespace tumble::tools {

namespace {

double time_run(const reference::QueryRun& run) {
    const double start = cpu_seconds();
    run();
    return cpu_seconds() - start;
}

}  // namespace

QueryBenchResult bench_queries(const reference::QueryCase& query_case, const QueryBenchOptions& options) {
    const bool is_slow = query_case.name.starts_with("1000-gon");  // Box2D takes 20 us per query
    const int pairs = is_slow ? options.pairs / 64 + 1 : options.pairs;
    const reference::QueryRuns runs = query_case.make(pairs, options.seed);
    std::vector<double> ours, theirs, of_v3;
    for (int run = -1; run < options.runs; ++run) {
        const double ns_a_query = 1e9 / pairs;
        const double tumble_ns = ns_a_query * time_run(runs.tumble), box2d_ns = ns_a_query * time_run(runs.box2d);
        const double v3_ns = runs.box2d_v3 ? ns_a_query * time_run(runs.box2d_v3) : 0.0;
        if (run < 0) continue;  // warms up the processor caches and the queries' own caches
        ours.push_back(tumble_ns);
        theirs.push_back(box2d_ns);
        of_v3.push_back(v3_ns);
    }
    return {query_case.name, median(ours), median(theirs), median(of_v3)};
}

}  // namespace tumble::tools
