// A scene as it runs: its world, what happens to it by its timeline, and what becomes of the claims it makes.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble {

// The step whose state is nearest to a time (s).
std::uint64_t nearest_step(double time, double steps_per_second);

// The steps from the start of a scene's run to its end.
std::uint64_t count_steps(const Scene& scene);

// Steps a scene's world. An event of time t happens before the first step that begins at t or later; step k (from 0)
// begins at k / steps_per_second. Events of one time happen in the order of the file.
class SceneRun {
public:
    // Throws SceneError as build_world() does.
    explicit SceneRun(const Scene& scene);
    ~SceneRun();
    SceneRun(SceneRun&&) noexcept;
    SceneRun& operator=(SceneRun&&) noexcept;

    // Lets the events happen that are due, and advances by one step. Throws SimulationDiverged, and SceneError for a
    // body that the world refuses to take.
    void step();

    double time() const;  // s, of the state that the world shows
    const SceneWorld& built() const noexcept;
    const World& world() const noexcept { return built().world; }

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// What became of one claim of a scene.
struct ExpectationResult {
    bool passed = false;
    std::string claim;       // "'crate' is inside [0, 0] to [2, 3] at 4 s"
    std::string finding;     // what was seen instead, or how near it was: "it is at [2.5, 0.5]"
    std::uint64_t step = 0;  // that decided it: the last one of a run that ended too early
    double time = 0.0;       // s, of that step
};

// Watches a run and decides the claims of its scene (Scene::expect).
//
// At rest is a body that sleeps, or whose farthest point is slower than 0.05 m/s (times the root of the world's scale),
// the speed below which bodies fall asleep; `at_rest_by` asks it of all dynamic bodies in all states from that time on.
// Bodies touch by the contact and sensor events of the steps. A claim of a state is looked at where
// SceneExpectation::when, at, from and until say. What the run never reaches has failed, and so has a claim of a body
// that is not there. The common name of copies claims a state of each of them (`always`: while there are any, which
// there must be sometime), and a touch of any.
class ExpectationWatch {
public:
    ExpectationWatch(const Scene& scene, const SceneWorld& built);
    ~ExpectationWatch();
    ExpectationWatch(ExpectationWatch&&) noexcept;
    ExpectationWatch& operator=(ExpectationWatch&&) noexcept;

    // To be called for the initial state and after each step.
    void observe(const SceneWorld& built);

    // [scene.expect.size()]
    std::vector<ExpectationResult> results() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tumble
