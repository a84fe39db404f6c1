#include "tumble/scene_run.hpp"

#include <limits>

#include "scene/names.hpp"

namespace tumble {

namespace {

constexpr double kSlack = 1e-6;  // of a step: times are decimal fractions, steps are not

}  // namespace

SceneRun::SceneRun(const Scene& scene) : built_(build_world(scene)) {
    const scene::BodyNames names(scene);
    for (const SceneEvent& event : scene.timeline) {
        if (!event.impulse) continue;
        Impulse impulse;
        impulse.body = built_.bodies[names.find(event.body).value()].id;
        impulse.impulse = to_float(*event.impulse);
        impulse.first = event.at.value_or(0.0);
        impulse.interval = event.every.value_or(0.0);
        impulse.last = event.every ? event.until.value_or(std::numeric_limits<double>::infinity()) : impulse.first;
        impulses_.push_back(impulse);
    }
}

void SceneRun::step() {
    for (Impulse& impulse : impulses_) apply(impulse);
    built_.world.step();
}

void SceneRun::apply(Impulse& impulse) {
    World& world = built_.world;
    const double slack = kSlack / world.def().steps_per_second;
    const double now = time() + slack;
    if (impulse.count > 0 && impulse.interval == 0.0) return;
    const double due = impulse.first + static_cast<double>(impulse.count) * impulse.interval;
    if (due > now || due > impulse.last + slack) return;
    const Pose pose = world.state(impulse.body).pose;
    world.apply_impulse(impulse.body, impulse.impulse, transform_point(pose, world.mass(impulse.body).center));
    ++impulse.count;
}

double SceneRun::time() const {
    return static_cast<double>(world().step_count()) / world().def().steps_per_second;
}

}  // namespace tumble
