// Times the steps of a scene's world and of a Box2D world that is built from the same scene.
#pragma once

#include <string>

#include "tools/bench/v3_program.hpp"
#include "tumble/counters.hpp"
#include "tumble/scene.hpp"

namespace tumble::tools {

struct StepBenchOptions {
    int steps = 200;  // of each engine in each run; fewer if the scene's duration is shorter
    int runs = 3;     // each from the initial state
    int threads = 1;  // of tumble and of the program, 0: one for each processor; others have one
    // If it has a scene of this name, it times Box2D v3, and all engines make as many steps as it does.
    const V3Program* v3_program = nullptr;
    bool uses_wall_clock() const { return threads != 1 || v3_program; }
};

struct StepBenchResult {
    std::string scene;
    std::size_t bodies = 0;  // of the tumble world, at the end
    int contacts = 0;
    double tumble_ms = 0.0;    // CPU or wall-clock time per step: mean of a run, median of the runs
    double box2d_ms = 0.0;     // 0: not timed, as Box2D does not run the timeline of the scene
    double box2d_v3_ms = 0.0;  // 0: not timed: this build lacks Box2D v3, or V3World cannot hold the scene
    StageTimes stages{};       // of tumble, wall clock: the means of all steps of a run of their own
    double ratio() const { return box2d_ms / tumble_ms; }
};

// The steps of a scene with a timeline include its events. Without one, the world alone makes the steps, as in Box2D.
// Measures CPU time for one thread, and wall-clock time for several. The engines alternate every few steps, so that
// changes of the machine's speed affect both alike.
StepBenchResult bench_steps(const Scene& scene, const StepBenchOptions& options);

}  // namespace tumble::tools
