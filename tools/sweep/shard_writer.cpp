#include "tools/sweep/shard_writer.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "sweep/hdf5/trajectory_file.hpp"
#include "sweep/store/stored_file.hpp"
#include "sweep/store/tar.hpp"
#include "tools/sweep/crash_log.hpp"

namespace tumble::tools {

namespace {

// "000000000042.events.csv": the name of a run's member of the tar file.
std::string member_name(std::uint64_t run, const std::string& suffix) {
    char text[32];
    std::snprintf(text, sizeof text, "%012llu.", static_cast<unsigned long long>(run));
    return text + suffix;
}

}  // namespace

std::optional<sweep::ShardEntry> write_shard(const sweep::Plan& plan, std::uint64_t shard,
                                             const std::filesystem::path& folder, RunMaker& runs,
                                             const ShardCalls& calls) {
    sweep::ShardEntry entry{.shard = shard};
    std::optional<sweep::StoredFileWriter> tar;
    if (plan.write.has_tar()) tar.emplace(folder, sweep::shard_file_name(shard, ".tar"));
    const std::uint64_t first = shard * runs_in_shard(plan), last = std::min(plan.runs, first + runs_in_shard(plan));
    const sweep::TrajectoryFormat format{plan.write.trajectory_every, plan.write.trajectory_bits};
    std::optional<sweep::TrajectoryFileWriter> trajectories;
    if (plan.write.has_hdf5()) trajectories.emplace(folder, sweep::shard_file_name(shard, ".h5"), format);
    sweep::StoredFileWriter table(folder, sweep::shard_file_name(shard, ".csv"));
    for (std::uint64_t run = first; run < last; ++run) {
        const auto crashed = calls.crashed.find(run);
        const RunMark mark(run);
        RunRecord record = crashed == calls.crashed.end() ? runs.make(run) : runs.record_crash(run, crashed->second);
        ++entry.outcomes[record.outcome];
        table.write(record.row);
        for (const auto& [suffix, bytes] : record.members)
            tar->write(sweep::tar_member(member_name(run, suffix), bytes));
        if (trajectories && record.trajectory.steps > 0)
            trajectories->append({run, record.is_stopped, std::move(record.trajectory)});
        calls.count_run();
    }
    if (!calls.may_commit()) return std::nullopt;
    if (tar) {
        tar->write(sweep::tar_end(tar->size()));
        entry.files.push_back(tar->commit());
    }
    if (trajectories) entry.files.push_back(trajectories->commit());
    entry.table = table.commit();
    return entry;
}

}  // namespace tumble::tools
