#include "tools/sweep/estimate.hpp"

#include <algorithm>
#include <string>

#include "sweep/store/tar.hpp"
#include "tools/measure/stopwatch.hpp"
#include "tools/sweep/runs/run_record.hpp"

namespace tumble::tools {

namespace {

std::size_t bytes_of(const sweep::Plan& plan, const RunRecord& record) {
    std::size_t bytes =
        record.row.size() + record.trajectory.numbers.size() * static_cast<std::size_t>(plan.write.trajectory_bits) / 8;
    for (const auto& [suffix, member] : record.members) bytes += sweep::tar_member(suffix, member).size();
    return bytes;
}

// Empty for a run that has an end state.
std::string failure_of(const RunRecord& record) {
    if (record.outcome == "ok" || record.outcome == "filtered") return {};
    return "run " + std::to_string(record.run) + " (" + record.outcome + "): " + record.message;
}

}  // namespace

SweepEstimate estimate_sweep(const sweep::Plan& plan, int jobs) {
    SweepEstimate estimate{.runs = plan.runs, .shards = shard_count(plan), .shard_runs = runs_in_shard(plan)};
    estimate.sampled = std::min(kSampledRuns, plan.runs);
    SceneTexts texts;
    RunMaker maker(plan, texts);
    std::size_t bytes = 0;
    const Stopwatch watch;
    for (std::uint64_t i = 0; i < estimate.sampled; ++i) {
        // In the middle of each twentieth, without a product beyond 64 bits.
        const std::uint64_t part = plan.runs / estimate.sampled;
        const RunRecord record = maker.make(i * part + part / 2);
        ++estimate.outcomes[record.outcome];
        if (estimate.failure.empty()) estimate.failure = failure_of(record);
        bytes += bytes_of(plan, record);
    }
    const auto sampled = static_cast<double>(estimate.sampled), runs = static_cast<double>(plan.runs);
    estimate.seconds_per_run = watch.seconds() / sampled;
    estimate.seconds =
        estimate.seconds_per_run * runs / std::min(static_cast<double>(jobs), static_cast<double>(estimate.shards));
    estimate.bytes = static_cast<double>(bytes) / sampled * runs;
    const std::uint64_t files_of_shard = (plan.write.has_tar() ? 1 : 0) + (plan.write.has_hdf5() ? 1 : 0);
    const std::uint64_t copies = plan.allow_outside ? 0 : 1 + plan.scenes.size();
    estimate.files = estimate.shards * files_of_shard + 2 + copies;
    return estimate;
}

}  // namespace tumble::tools
