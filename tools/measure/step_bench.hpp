// Times the steps of a scene's world beside those of a Box2D world made from the same scene.
#pragma once

#include <string>

#include "tumble/scene.hpp"

namespace tumble::tools {

struct StepBenchOptions {
    int steps = 200;  // of each engine in each run; fewer if the scene's duration is shorter
    int runs = 3;     // each from the initial state
};

struct StepBenchResult {
    std::string scene;
    std::size_t bodies = 0;
    int contacts = 0;        // of ours, at the end
    double tumble_ms = 0.0;  // CPU time of a step: mean of a run, median of the runs
    double box2d_ms = 0.0;
    double ratio() const { return box2d_ms / tumble_ms; }
};

// The engines take turns every few steps, so that whatever else the machine does meets both alike.
StepBenchResult bench_steps(const Scene& scene, const StepBenchOptions& options);

}  // namespace tumble::tools
