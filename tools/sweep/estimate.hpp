// What a sweep will cost, from a sample of its runs.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "sweep/plan/plan.hpp"

namespace tumble::tools {

struct SweepEstimate {
    std::uint64_t runs = 0, shards = 0, shard_runs = 0;
    std::uint64_t sampled = 0;
    std::map<std::string, std::uint64_t> outcomes{};  // of the sample
    std::string failure{};                            // the first run of the sample without an end state, and why
    double seconds_per_run = 0.0;                     // on one thread
    double seconds = 0.0;                             // of all runs, on `jobs` threads, without storing files
    double bytes = 0.0;                               // of all files, without the metadata of HDF5
    std::uint64_t files = 0;                          // at the end
};

inline constexpr std::uint64_t kSampledRuns = 20;

// Simulates runs that are spread evenly over the plan, and writes nothing.
SweepEstimate estimate_sweep(const sweep::Plan& plan, int jobs);

}  // namespace tumble::tools
