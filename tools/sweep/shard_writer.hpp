// Writes the files of one shard.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "sweep/plan/plan.hpp"
#include "sweep/store/manifest.hpp"
#include "tools/sweep/run_record.hpp"

namespace tumble::tools {

// Simulates the runs of a shard and writes its files, each complete or not at all: the lines of its runs, a tar file
// and an HDF5 file if the plan asks for them. `count_run` is called after each run. Throws FileError and Interrupted.
sweep::ShardEntry write_shard(const sweep::Plan& plan, std::uint64_t shard, const std::filesystem::path& folder,
                              SceneTexts& texts, const std::function<void()>& count_run);

}  // namespace tumble::tools
