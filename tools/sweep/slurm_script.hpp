// A sweep as a job array of Slurm.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sweep/plan/plan.hpp"

namespace tumble::tools {

struct SlurmOptions {
    std::filesystem::path folder;       // of the results, on a file system that all nodes see
    std::uint64_t tasks = 0;            // 0: as many as take kSecondsOfTask each
    std::vector<std::string> settings;  // further options of sbatch, each "--name=value"
    std::string program = "tumble";     // as the nodes find it
};

// A task costs Slurm a second or more, so that shorter ones keep its scheduler busy and the nodes idle.
inline constexpr double kSecondsOfTask = 60.0;
inline constexpr std::uint64_t kMostTasks = 1000;  // the default limit of Slurm for arrays

// How many tasks make a sweep of this duration (s on one thread).
std::uint64_t choose_tasks(const sweep::Plan& plan, double seconds);

// The tasks of `tasks` that have missing shards: "0-7", "1,4-5"; empty if all shards are stored.
std::string missing_tasks(const sweep::Plan& plan, const std::filesystem::path& folder, std::uint64_t tasks);

// The script of the array, for sbatch. A task that is ended by TERM, or with its node, continues when it is queued
// again, and when the script is submitted again.
std::string slurm_script(const sweep::Plan& plan, const SlurmOptions& options, const std::string& array);

// The script of the job that completes the folder after the array.
std::string merge_script(const sweep::Plan& plan, const SlurmOptions& options);

}  // namespace tumble::tools
