#include "tumble/scene_run.hpp"

#include <cmath>
#include <limits>

#include "scene/model/display.hpp"
#include "scene/model/step_time.hpp"
#include "scene/run/motor_work.hpp"
#include "scene/run/saved_run.hpp"
#include "scene/run/timeline_run.hpp"
#include "tumble/scene_file.hpp"

namespace tumble {

struct SceneRun::Impl {
    explicit Impl(const Scene& scene) : built(build_world(scene)), timeline(scene, built), motors(built) {}

    SceneWorld built;
    scene::TimelineRun timeline;
    scene::MotorWork motors;
    bool counts_motors = true;
};

namespace {

// A state depends on the steps before it, not on those that follow.
std::uint64_t hash_without_duration(Scene scene) {
    scene.world.duration = SceneSettings{}.duration;
    return scene_hash(scene);
}

}  // namespace

std::uint64_t nearest_step(double time, double steps_per_second) {
    return static_cast<std::uint64_t>(std::llround(time * steps_per_second));
}

std::uint64_t count_steps(const Scene& scene) {
    return nearest_step(scene.world.duration, scene.world.steps_per_second);
}

std::vector<std::uint64_t> steps_of_event(const SceneEvent& event, double steps_per_second, std::uint64_t last,
                                          std::size_t most) {
    if (!event.when.empty()) return {};
    const double until = event.until.value_or(std::numeric_limits<double>::infinity());
    const double slack = scene::kTimeSlack / steps_per_second;
    std::vector<std::uint64_t> steps;
    while (steps.size() < (event.every ? most : 1)) {
        const double repeats = static_cast<double>(steps.size()) * event.every.value_or(0.0);
        const double due = event.at.value_or(event.from.value_or(0.0) + repeats);
        const std::uint64_t step = scene::first_step_at(due, steps_per_second);
        if (step > last || (event.every && due > until + slack)) break;
        steps.push_back(step);
    }
    return steps;
}

SceneRun::SceneRun(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
SceneRun::~SceneRun() = default;
SceneRun::SceneRun(SceneRun&&) noexcept = default;
SceneRun& SceneRun::operator=(SceneRun&&) noexcept = default;

void SceneRun::step() {
    SceneWorld& built = impl_->built;
    impl_->timeline.apply_due(built);
    if (impl_->counts_motors) impl_->motors.start_step(built.world);
    try {
        built.world.step();
    } catch (const SimulationDiverged& error) {
        throw SimulationDiverged(error.body, error.step, scene::display_name(built, error.body));
    }
    const double work = built.work;
    impl_->timeline.add_work(built);
    if (impl_->counts_motors) built.work += impl_->motors.end_step(built.world, built.work - work);
    impl_->timeline.watch(built);
}

bool SceneRun::is_stopped() const noexcept { return impl_->timeline.is_stopped(impl_->built); }

void SceneRun::set_threads(const Threads& threads) { impl_->built.world.set_threads(threads); }

void SceneRun::count_motor_work(bool counts) {
    if (counts && !impl_->counts_motors) impl_->motors = scene::MotorWork(impl_->built);
    impl_->counts_motors = counts;
}

std::vector<std::byte> SceneRun::save(const Scene& scene) const {
    const SceneWorld& built = impl_->built;
    const scene::SavedRun saved{hash_without_duration(scene), built.bodies, impl_->timeline.state(), built.work,
                                built.world.save()};
    return scene::to_bytes(saved);
}

SceneRun SceneRun::load(const Scene& scene, std::span<const std::byte> saved) {
    scene::SavedRun read = scene::read_saved_run(saved);
    SceneRun run(scene);
    Impl& impl = *run.impl_;
    if (read.scene_hash != hash_without_duration(scene) || !impl.timeline.set_state(read.events, impl.built.world))
        throw SnapshotError("the saved run is that of another scene");
    if (read.bodies.size() < impl.built.bodies.size())
        throw SnapshotError("the saved run has fewer bodies than its scene");
    impl.built.world = World::load(read.world);
    impl.built.bodies = std::move(read.bodies);
    impl.built.work = read.work;
    return run;
}

double SceneRun::time() const { return impl_->built.world.time(); }

World& SceneRun::world() noexcept { return impl_->built.world; }

const SceneWorld& SceneRun::built() const noexcept { return impl_->built; }

}  // namespace tumble
