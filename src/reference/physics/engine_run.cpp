#include "reference/physics/engine_run.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>

#include "reference/box2d/b2_world.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::reference {

namespace {

class TumbleRun final : public EngineRun {
public:
    explicit TumbleRun(const Scene& scene) : EngineRun(scene), built_(build_world(scene)) {}

    BodyMotion body(int index) const override {
        const BodyId id = built_.bodies[static_cast<std::size_t>(index)].id;
        const BodyState state = built_.world.state(id);
        return {.position = state.pose.position,
                .angle = angle(state.pose.rotation),
                .velocity = DVec2(state.velocity),
                .spin = state.angular_velocity,
                .awake = built_.world.is_awake(id)};
    }

private:
    void advance() override { built_.world.step(); }

    SceneWorld built_;
};

class Box2dRun final : public EngineRun {
public:
    explicit Box2dRun(const Scene& scene) : EngineRun(scene), world_(scene) {}

    BodyMotion body(int index) const override {
        const Pose pose = world_.pose(index);
        return {.position = pose.position,
                .angle = angle(pose.rotation),
                .velocity = DVec2(world_.velocity(index)),
                .spin = world_.angular_velocity(index),
                .awake = world_.is_awake(index)};
    }

private:
    void advance() override { world_.step(); }

    B2World world_;
};

DVec2 rotated(double angle, Vec2 v) {
    const double c = std::cos(angle), s = std::sin(angle);
    const DVec2 d(v);
    return {c * d.x - s * d.y, s * d.x + c * d.y};
}

double process_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

EngineRun::EngineRun(const Scene& scene)
    : gravity_(scene.world.gravity), step_duration_(1.0 / scene.world.steps_per_second) {
    const SceneWorld built = build_world(scene);
    std::map<BodyId, int> index_of;
    for (const SceneInstance& instance : built.bodies) {
        const BodyMass mass = built.world.mass(instance.id);
        index_of[instance.id] = static_cast<int>(masses_.size());
        masses_.push_back({.mass = mass.mass, .inertia = mass.inertia, .center = mass.center});
    }
    for (const JointId id : built.world.joints())
        if (const auto* hinge = std::get_if<RevoluteJointDef>(&built.world.joint(id)))
            hinges_.push_back({.body_a = index_of.at(hinge->body_a),
                               .body_b = index_of.at(hinge->body_b),
                               .anchor_a = hinge->anchor_a,
                               .anchor_b = hinge->anchor_b});
}

void EngineRun::step() {
    const double start = process_seconds();
    advance();
    cpu_seconds_ += process_seconds() - start;
    ++steps_;
}

void EngineRun::run_until(double time) {
    const long last = std::lround(time / step_duration_);
    while (steps_ < last) step();
}

double EngineRun::step_milliseconds() const { return 1e3 * cpu_seconds_ / static_cast<double>(std::max(1L, steps_)); }

DVec2 EngineRun::center(int index) const {
    const BodyMotion motion = body(index);
    return motion.position + rotated(motion.angle, masses_[static_cast<std::size_t>(index)].center);
}

double EngineRun::kinetic_energy() const {
    double energy = 0.0;
    for (int index = 0; index < body_count(); ++index) {
        if (!is_dynamic(index)) continue;
        const BodyMotion motion = body(index);
        const double inertia = masses_[static_cast<std::size_t>(index)].inertia;
        energy += 0.5 * mass(index) * length_sq(motion.velocity) + 0.5 * inertia * motion.spin * motion.spin;
    }
    return energy;
}

double EngineRun::potential_energy() const {
    double energy = 0.0;
    for (int index = 0; index < body_count(); ++index)
        if (is_dynamic(index)) energy -= mass(index) * dot(gravity_, center(index));
    return energy;
}

double EngineRun::widest_gap() const {
    double widest = 0.0;
    for (const Hinge& hinge : hinges_) {
        const BodyMotion a = body(hinge.body_a), b = body(hinge.body_b);
        const DVec2 gap = b.position + rotated(b.angle, hinge.anchor_b) - a.position - rotated(a.angle, hinge.anchor_a);
        widest = std::max(widest, length(gap));
    }
    return widest;
}

bool EngineRun::all_asleep() const {
    for (int index = 0; index < body_count(); ++index)
        if (is_dynamic(index) && body(index).awake) return false;
    return true;
}

std::unique_ptr<EngineRun> start(Engine engine, const Scene& scene) {
    if (engine == Engine::box2d) return std::make_unique<Box2dRun>(scene);
    Scene own = scene;
    if (engine == Engine::at_step_end) own.world.impacts = ImpactModel::at_step_end;
    return std::make_unique<TumbleRun>(own);
}

}  // namespace tumble::reference
