// The work of one process on a sweep: it simulates shards that no other process has.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "sweep/plan/plan.hpp"
#include "tools/sweep/sweep_folder.hpp"

namespace tumble::tools {

struct SweepOptions {
    std::filesystem::path folder{};
    int jobs = 1;            // threads, each with a shard of its own
    std::uint64_t part = 0;  // of `parts`: this process makes the shards s with s % parts == part
    std::uint64_t parts = 1;
    double lease = 60.0;  // s after which the shard of a process that no one hears of is taken over
    bool check = false;   // read all files first, and make those again whose checksums are wrong
};

struct SweepReport {
    std::uint64_t runs = 0;                           // of the plan
    std::uint64_t shards = 0;                         // of the plan
    std::uint64_t simulated_runs = 0;                 // by this process
    std::map<std::string, std::uint64_t> outcomes{};  // of all complete shards
    std::uint64_t missing_shards = 0;
    std::uint64_t missing_of_part = 0;  // of these, shards that this process should have made
    double seconds = 0.0;
    bool complete = false;     // the whole folder
    bool interrupted = false;  // by a signal
};

// Continues the sweep in the folder, or begins it. Without parts it returns when all shards are there and the folder is
// complete; it waits for shards that other processes write. Throws FileError, also for a folder of another sweep.
SweepReport run_sweep(const sweep::Plan& plan, const SweepOptions& options);

}  // namespace tumble::tools
