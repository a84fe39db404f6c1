// A scene as it runs: its world, what happens to it by its timeline, and what becomes of the claims it makes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tumble/scene.hpp"

namespace tumble {

// Steps a scene's world. An event of time t happens before the first step that begins at t or later; step k (from 0)
// begins at k / steps_per_second. Events of one time happen in the order of the file.
class SceneRun {
public:
    // Throws SceneError as build_world() does.
    explicit SceneRun(const Scene& scene);

    // Lets the events happen that are due, and advances by one step. Throws SimulationDiverged.
    void step();

    double time() const;  // s, of the state that the world shows
    const SceneWorld& built() const noexcept { return built_; }
    const World& world() const noexcept { return built_.world; }

private:
    // An impulse of the timeline, at step `next` and every `interval` seconds after `first` until `last`.
    struct Impulse {
        BodyId body;
        Vec2 impulse;        // N s
        double first = 0.0;  // s
        double interval = 0.0;
        double last = 0.0;
        std::uint64_t count = 0;  // how often it has happened
    };

    void apply(Impulse& impulse);

    SceneWorld built_;
    std::vector<Impulse> impulses_;
};

// What became of one claim of a scene.
struct ExpectationResult {
    bool passed = false;
    std::string claim;        // "'crate' is inside [0, 0] to [2, 3] at 4 s"
    std::string finding;      // what was seen instead, or how near it was: "it is at [2.5, 0.5]"
    std::uint64_t step = 0;   // that decided it
};

// Watches a run and decides the claims of its scene (Scene::expect), which the scene outlives.
//
// At rest is a body that sleeps, or whose farthest point is slower than 0.05 m/s, the speed below which bodies fall
// asleep; `at_rest_by` asks it of all dynamic bodies in all steps from that time on. `max_penetration` looks at every
// contact point of every step, `inside` at one moment. What the run never reaches has failed.
class ExpectationWatch {
public:
    ExpectationWatch(const Scene& scene, const SceneWorld& built);

    // To be called for the initial state and after each step.
    void observe(const SceneWorld& built);

    // [scene.expect.size()]
    std::vector<ExpectationResult> results() const;

private:
    // What is known so far of a claim; the measure of what was seen (m/s or m) is the worst one.
    struct Claim {
        std::size_t body = 0;    // of the built ones, for `inside`
        std::uint64_t from = 0;  // the first step that counts
        std::uint64_t to = 0;    // the last one
        bool seen = false;
        bool failed = false;
        double worst = 0.0;
        std::string finding;
        std::uint64_t step = 0;
    };

    void observe_rest(Claim& claim, const SceneWorld& built) const;
    void observe_depth(Claim& claim, double limit, const SceneWorld& built) const;
    void observe_place(Claim& claim, const std::pair<DVec2, DVec2>& box, const SceneWorld& built) const;

    const Scene& scene_;
    std::vector<double> reach_;  // [built bodies] m: of the farthest point from the centre of mass
    std::vector<Claim> claims_;  // [scene_.expect.size()]
};

}  // namespace tumble
