// One run of a sweep: its simulation, its line of the table, and the data that the plan asks for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "sweep/plan/plan.hpp"
#include "sweep/store/trajectory_array.hpp"

namespace tumble::tools {

// The texts of scene files and of their includes, read once for all runs and threads.
class SceneTexts {
public:
    const std::string& read(const std::filesystem::path& file);

private:
    std::mutex mutex_;
    std::map<std::filesystem::path, std::string> texts_;
};

struct RunRecord {
    std::uint64_t run = 0;
    // "ok"; "filtered": the filter drops its data; "diverged", "timed_out", "invalid": it has no end state.
    std::string outcome;
    std::string row{};                                           // its line of the table
    std::vector<std::pair<std::string, std::string>> members{};  // of the tar file: suffix and bytes
    sweep::TrajectoryArray trajectory{};                         // for the HDF5 file
    std::uint64_t steps = 0;
};

// Thrown after SIGINT, SIGHUP or SIGTERM.
struct Interrupted {};

// The bytes of the record depend on the plan and the run alone, except for `timed_out`. A run that diverges, takes too
// long or has a scene that is not valid is recorded as such. Throws FileError and Interrupted.
RunRecord simulate_run(const sweep::Plan& plan, std::uint64_t run, SceneTexts& texts);

}  // namespace tumble::tools
