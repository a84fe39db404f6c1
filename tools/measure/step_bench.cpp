#include "tools/measure/step_bench.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/box2d/b2_world.hpp"
#include "reference/box2d_v3/v3_queries.hpp"
#include "reference/box2d_v3/v3_world.hpp"
#include "tools/measure/cpu_clock.hpp"
#include "tools/measure/median.hpp"
#include "tools/measure/stopwatch.hpp"
#include "tumble/scene_run.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::tools {

namespace {

// Steps before the engines alternate: short compared with drifts of the machine's speed, long compared with refilling
// the caches.
constexpr int kTurn = 10;

template <class World>
double time_steps(World& world, int count, const StepBenchOptions& options) {
    const Stopwatch watch;
    const double start = cpu_seconds();
    for (int i = 0; i < count; ++i) world.step();
    return options.uses_wall_clock() ? watch.seconds() : cpu_seconds() - start;
}

int steps_of(const Scene& scene, const StepBenchOptions& options) {
    const std::uint64_t most = static_cast<std::uint64_t>(options.steps);
    return std::max(1, static_cast<int>(std::min(most, count_steps(scene))));
}

}  // namespace

StepBenchResult bench_steps(const Scene& scene, const StepBenchOptions& options) {
    StepBenchResult result;
    result.scene = scene.name;
    const int steps = steps_of(scene, options);
    std::vector<double> ours, theirs, of_v3;  // ms per step, of each run
    const bool has_v3 = reference::has_box2d_v3() && reference::V3World::can_hold(scene);
    for (int run = 0; run < options.runs; ++run) {
        SceneWorld tumble_world = build_world(scene);
        tumble_world.world.set_threads({.count = options.threads});
        reference::B2World box2d_world(scene);
        std::optional<reference::V3World> v3_world;
        if (has_v3) v3_world.emplace(scene);
        double tumble_seconds = 0.0, box2d_seconds = 0.0, v3_seconds = 0.0;
        for (int done = 0; done < steps; done += kTurn) {
            const int count = std::min(kTurn, steps - done);
            tumble_seconds += time_steps(tumble_world.world, count, options);
            box2d_seconds += time_steps(box2d_world, count, options);
            if (v3_world) v3_seconds += time_steps(*v3_world, count, options);
        }
        ours.push_back(1e3 * tumble_seconds / steps);
        theirs.push_back(1e3 * box2d_seconds / steps);
        of_v3.push_back(1e3 * v3_seconds / steps);
        result.bodies = tumble_world.bodies.size();
        result.contacts = tumble_world.world.counters().contacts;
    }
    result.tumble_ms = median(ours);
    result.box2d_ms = median(theirs);
    result.box2d_v3_ms = median(of_v3);
    return result;
}

}  // namespace tumble::tools
