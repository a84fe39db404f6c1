// Verifies the folder of a sweep: checksums of all files, and a sample of the runs made again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sweep/plan/plan.hpp"

namespace tumble::tools {

struct Verification {
    std::uint64_t files = 0, bytes = 0;   // that were read
    bool has_damaged_copies = false;      // of the plan, its scenes or images
    std::uint64_t repeated_runs = 0;      // that were simulated again
    std::uint64_t seed = 0;               // from which these runs are drawn
    std::vector<std::string> findings{};  // what is wrong; empty if nothing is
};

// Reads all files of the complete shards, and finds shards that are missing. Throws FileError if there is no sweep.
Verification verify_files(const std::filesystem::path& folder);

// Removes the files of complete shards, the table, and the copies of scenes, whose checksums are not those of the
// manifest, so that the sweep makes them again. What a link in the place of a folder names is not removed.
void remove_damaged_files(const std::filesystem::path& folder);

// Simulates a part of the stored runs again, drawn from the seed, at least one, and compares the lines of the table,
// which have the checksums of all data of a run. Runs that timed out, failed or crashed are left out, because that may
// depend on the machine. Throws FileError for a plan of another sweep, and for frames that this machine draws by other
// software.
void verify_runs(const sweep::Plan& plan, const std::filesystem::path& folder, double part, Verification& verification);

}  // namespace tumble::tools
