// Two runs step by step: the differences that `diff` finds, for plots, tables and pages.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tools/diff/trajectory_diff.hpp"

namespace tumble::tools {

// What is compared: two runs, or one scene in tumble and in Box2D.
struct CompareInputs {
    std::string a, b;  // as `diff` takes them; b is empty if the engines are compared
    LoadOptions changes_a, changes_b;
};

struct ComparedSources {
    std::unique_ptr<StateSource> a, b;
    std::string name_a, name_b;      // in legends and captions
    std::vector<std::string> notes;  // what B leaves out of the scene
};

// Throws as open_states().
ComparedSources open_sources(const CompareInputs& inputs);

inline constexpr std::size_t kPosition = 0, kVelocity = 2;  // indices into kKinds and StepDifference

struct ComparedStep {
    std::uint64_t step = 0;
    double time = 0.0;                      // s
    StepDifference largest;                 // as `diff` finds them
    double energy_a = 0.0, energy_b = 0.0;  // J; NaN if it is not known
};

struct ComparedRuns {
    std::string name_a, name_b;
    std::vector<std::string> notes;
    Comparison comparison;
    std::vector<ComparedStep> steps;  // that both runs have
};

// Throws as StateSource::next().
ComparedRuns compare_runs(const CompareInputs& inputs, double tolerance);

// The first step in which a kind of difference exceeds a bound; null if none does.
const ComparedStep* first_beyond(const ComparedRuns& runs, std::size_t kind, double bound);

// "step,time,position,angle,velocity,angular_velocity,energy_a,energy_b" and a line for each step.
std::string to_csv(const ComparedRuns& runs);

}  // namespace tumble::tools
