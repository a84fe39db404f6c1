#include "tools/bench/step_bench.hpp"

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
#include "tools/output/step_stages.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

namespace {

// Steps before the engines alternate: short compared with drifts of the machine's speed, long compared with refilling
// the caches.
constexpr int kTurn = 10;

// The steps of a scene in tumble. Without a timeline the world alone makes them, as in Box2D.
class TumbleSteps {
public:
    TumbleSteps(const Scene& scene, int threads) : run_(scene), has_timeline_(!scene.timeline.empty()) {
        run_.set_threads({.count = threads});
        run_.count_motor_work(false);  // Box2D does not measure it
    }

    // Does nothing after the timeline has ended the run.
    void step() {
        if (has_timeline_ && run_.is_stopped()) return;
        if (has_timeline_)
            run_.step();
        else
            run_.world().step();
        ++taken_;
    }

    const SceneRun& run() const { return run_; }
    int taken() const { return taken_; }

private:
    SceneRun run_;
    bool has_timeline_;
    int taken_ = 0;
};

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

// A run in which nothing is timed but the stages.
StageTimes mean_stages(const Scene& scene, int steps, int threads) {
    TumbleSteps tumble(scene, threads);
    StageTimes sum;
    for (int i = 0; i < steps; ++i) {
        tumble.step();
        const StageTimes ms = tumble.run().world().counters().ms;
        if (tumble.taken() <= i) break;
        for (const StepStage& stage : kStepStages) sum.*stage.ms += ms.*stage.ms;
    }
    for (const StepStage& stage : kStepStages) sum.*stage.ms /= std::max(tumble.taken(), 1);
    return sum;
}

}  // namespace

StepBenchResult bench_steps(const Scene& scene, const StepBenchOptions& options) {
    StepBenchResult result;
    result.scene = scene.name;
    const V3Program* const program =
        options.v3_program && options.v3_program->has(scene.name) ? options.v3_program : nullptr;
    const bool has_v3 = !program && reference::has_box2d_v3() && reference::V3World::can_hold(scene);
    int steps = steps_of(scene, options);
    std::vector<double> ours, theirs, of_v3;  // ms per step, of each run
    for (int run = 0; run < options.runs; ++run) {
        if (program) {
            const V3Program::Run timed = program->run(scene.name, options.threads);
            steps = timed.steps;
            of_v3.push_back(timed.ms);
        }
        TumbleSteps tumble(scene, options.threads);
        std::optional<reference::B2World> box2d_world;
        if (scene.timeline.empty()) box2d_world.emplace(scene);
        std::optional<reference::V3World> v3_world;
        if (has_v3) v3_world.emplace(scene);
        double tumble_seconds = 0.0, box2d_seconds = 0.0, v3_seconds = 0.0;
        for (int done = 0; done < steps; done += kTurn) {
            const int count = std::min(kTurn, steps - done);
            tumble_seconds += time_steps(tumble, count, options);
            if (box2d_world) box2d_seconds += time_steps(*box2d_world, count, options);
            if (v3_world) v3_seconds += time_steps(*v3_world, count, options);
        }
        ours.push_back(1e3 * tumble_seconds / std::max(tumble.taken(), 1));
        theirs.push_back(1e3 * box2d_seconds / steps);
        if (!program) of_v3.push_back(1e3 * v3_seconds / steps);
        result.bodies = static_cast<std::size_t>(tumble.run().world().counters().bodies);
        result.contacts = tumble.run().world().counters().contacts;
    }
    result.tumble_ms = median(ours);
    result.box2d_ms = median(theirs);
    result.box2d_v3_ms = median(of_v3);
    result.stages = mean_stages(scene, steps, options.threads);
    return result;
}

}  // namespace tumble::tools
