// Times the steps of a scene's world and of a Box2D world that is built from the same scene.
#pragma once

#include <string>

#include "tumble/scene.hpp"

namespace tumble::tools {

struct StepBenchOptions {
    int steps = 200;  // of each engine in each run; fewer if the scene's duration is shorter
    int runs = 3;     // each from the initial state
    int threads = 1;  // of tumble, 0: one for each processor; Box2D has one
    bool uses_wall_clock() const { return threads != 1; }
};

struct StepBenchResult {
    std::string scene;
    std::size_t bodies = 0;
    int contacts = 0;        // of the tumble world, at the end
    double tumble_ms = 0.0;  // CPU or wall-clock time per step: mean of a run, median of the runs
    double box2d_ms = 0.0;
    double box2d_v3_ms = 0.0;  // 0: not timed: this build lacks Box2D v3, or V3World cannot hold the scene
    double ratio() const { return box2d_ms / tumble_ms; }
};

// Measures CPU time for one thread, and wall-clock time for several. The engines alternate every few steps, so that
// changes of the machine's speed affect both alike.
StepBenchResult bench_steps(const Scene& scene, const StepBenchOptions& options);

}  // namespace tumble::tools
