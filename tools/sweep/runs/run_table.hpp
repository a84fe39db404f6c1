// The table of a sweep, runs.csv: one line for each run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sweep/plan/plan.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

// What a run found.
struct RunFindings {
    std::string outcome = "ok";
    std::string message{};                 // why there is no end state
    std::optional<std::uint64_t> steps{};  // nothing if the scene is not valid, or if the run took too long
    std::vector<ExpectationResult> claims{};
    std::vector<double> measures{};  // empty if there is no end state
    std::optional<std::uint64_t> state_hash{};
    std::vector<SceneDraw> draws{};     // the random numbers of the scene
    std::vector<std::string> bodies{};  // in the order of trajectories; the label of a body in masks is its index + 1

    std::size_t failed_claims() const;
};

std::vector<std::string> parameter_names(const sweep::Plan& plan);

// run, scene, seed, the parameters, outcome, steps, claims, failed_claims, the measures, state_hash, data_hash,
// message.
std::string table_header(const sweep::Plan& plan);
std::string table_row(const sweep::Plan& plan, const sweep::RunChoice& choice, const RunFindings& found,
                      std::uint64_t data_hash);

// The same as JSON, with the random numbers of the scene and the claims.
std::string summary_text(const sweep::Plan& plan, const sweep::RunChoice& choice, const RunFindings& found);

}  // namespace tumble::tools
