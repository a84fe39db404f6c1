// Running a scene against the claims it makes about itself, without drawing it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/cli/exit_code.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

// What became of one scene file.
struct SceneCheck {
    std::string file;
    ExitCode code = ExitCode::ok;  // failed, or why the scene could not be run
    std::string error;             // of a scene that could not be read, or not be run to its end
    std::string name;              // of the scene, as a file name; of the file, if it cannot be read
    std::vector<ExpectationResult> expectations;
    std::vector<std::filesystem::path> shots;  // [expectations.size()], or none: pictures of those that failed
    std::uint64_t steps = 0;
    std::uint64_t state_hash = 0;
    double seconds = 0.0;  // of wall clock
};

// Never throws for what is wrong with one scene. Stops early, with `interrupted`, on SIGINT or SIGTERM.
SceneCheck check_scene_file(const std::string& file, const LoadOptions& changes);

// The same for all, on so many threads; in the order of the files, whatever the threads do.
std::vector<SceneCheck> check_scene_files(const std::vector<std::string>& files, const LoadOptions& changes,
                                          int threads);

// "at 1.5 s (step 90)": when a claim was decided.
std::string moment_text(const ExpectationResult& result);

// "/expect/3", where the file has a claim.
std::string pointer_of_claim(std::size_t index);

// As JUnit XML, which services that run tests read: a suite for each scene, a case for each claim.
std::string to_junit(const std::vector<SceneCheck>& checks);

}  // namespace tumble::tools
