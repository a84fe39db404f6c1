// Writes the files of one shard.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "sweep/plan/plan.hpp"
#include "sweep/store/manifest.hpp"
#include "tools/sweep/runs/run_record.hpp"

namespace tumble::tools {

// What a shard gets from the work of which it is a part.
struct ShardCalls {
    std::function<void()> count_run;   // after each run
    std::function<bool()> may_commit;  // before the first file gets its name: not if another process has the shard
    std::map<std::uint64_t, std::string> crashed{};  // runs that are not simulated, and the signals that ended them
};

// Simulates the runs of a shard and writes its files, each complete or not at all: the lines of its runs, a tar file
// and an HDF5 file if the plan asks for them. Nothing is written, and nothing returned, if it may not. Throws FileError
// and Interrupted.
std::optional<sweep::ShardEntry> write_shard(const sweep::Plan& plan, std::uint64_t shard,
                                             const std::filesystem::path& folder, RunMaker& runs,
                                             const ShardCalls& calls);

}  // namespace tumble::tools
