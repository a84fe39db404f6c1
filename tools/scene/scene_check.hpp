// Simulates scenes without drawing them, and evaluates their claims ("expect").
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/cli/exit_code.hpp"
#include "tumble/render.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

// A `state_hash` claim whose hash was replaced.
struct UpdatedHash {
    std::string pointer;
    std::string before, after;
};

// The file of a `picture` claim that was missing.
struct WrittenPicture {
    std::string pointer;
    std::filesystem::path file;
};

// The result of one scene file.
struct SceneCheck {
    std::string file;
    ExitCode code = ExitCode::ok;  // `failed` if a claim does not hold or `failure` is not empty; the code of `error`
    std::string error;             // why the scene could not be read, simulated to its end or updated; else empty
    std::string failure;           // why the scene fails without a failed claim; else empty
    bool was_simulated = false;    // to its end, with its claims evaluated
    std::string name;              // of the scene, as a file name; of the file if the scene cannot be read
    std::vector<ExpectationResult> expectations;
    std::vector<std::filesystem::path> shots;  // [expectations.size()] or empty: a picture of each failed claim
    std::vector<std::string> claimed_hashes;   // [expectations.size()]: of `state_hash` claims, else empty
    std::vector<UpdatedHash> updated;
    std::vector<WrittenPicture> pictures;
    std::uint64_t steps = 0;
    std::uint64_t state_hash = 0;
    double seconds = 0.0;      // wall clock
    bool was_skipped = false;  // after a failure, with stop_at_failure
};

struct CheckOptions {
    LoadOptions changes{};
    int threads = 1;
    bool require_claims = false;                        // a scene without claims fails
    bool stop_at_failure = false;                       // begin no other scene after one that fails
    bool update = false;                                // write the files of `picture` claims that are missing
    RenderBackend renderer = RenderBackend::automatic;  // of pictures
};

// An error of the scene is part of the result, not an exception. On SIGINT, SIGHUP or SIGTERM it stops with
// interruption_code().
SceneCheck check_scene_file(const std::string& file, const CheckOptions& options);

// The same for each file. The results are in the order of the files.
std::vector<SceneCheck> check_scene_files(const std::vector<std::string>& files, const CheckOptions& options);

// "at 1.5 s (step 90)": when a claim was decided.
std::string moment_text(const ExpectationResult& result);

// "/expect/3": the JSON pointer of a claim in its file.
std::string pointer_of_claim(std::size_t index);

}  // namespace tumble::tools
