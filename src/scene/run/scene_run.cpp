#include "tumble/scene_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include "debug/check.hpp"
#include "scene/json/diagnostics.hpp"
#include "scene/model/body_lookup.hpp"
#include "scene/model/body_plan.hpp"
#include "scene/model/degrees.hpp"
#include "scene/model/display.hpp"
#include "scene/model/names.hpp"
#include "scene/model/place_copies.hpp"
#include "scene/model/repeat.hpp"
#include "scene/model/step_time.hpp"
#include "scene/run/saved_run.hpp"
#include "tumble/scene_file.hpp"

namespace tumble {

namespace {

// One entry of the timeline, with its names looked up and its body planned.
struct ScheduledEvent {
    SceneEvent event;
    std::size_t index = 0;   // in the timeline
    scene::BodyLookup body;  // that it acts on or despawns
    std::optional<JointId> joint;
    std::optional<scene::BodyPlan> plan;  // of the body that it spawns
    std::uint64_t count = 0;              // how often it has occurred
    std::size_t spawned = 0;              // how many bodies it has spawned

    bool lasts() const { return event.force || event.torque; }
};

// Does nothing if the joint has no motor.
void set_motor_speed(JointDef& joint, double speed) {
    std::visit(
        [speed](auto& def) {
            if constexpr (requires { def.motor; }) {
                if (!def.motor) return;
                const bool turns = std::is_same_v<std::decay_t<decltype(*def.motor)>, AngularMotor>;
                def.motor->speed = static_cast<float>(turns ? speed * scene::kRadians : speed);
            }
        },
        joint);
}

DVec2 center_of(const World& world, BodyId body) {
    return transform_point(world.state(body).pose, world.mass(body).center);
}

}  // namespace

struct SceneRun::Impl {
    explicit Impl(const Scene& scene)
        : built(build_world(scene)), name(scene.name), seed(scene.world.seed), bodies_of_file(scene.bodies.size()) {
        for (std::size_t i = 0; i < scene.timeline.size(); ++i) {
            const SceneEvent& event = scene.timeline[i];
            ScheduledEvent& scheduled = events.emplace_back();
            scheduled.event = event;
            scheduled.index = i;
            scheduled.body = scene::BodyLookup(event.despawn.empty() ? event.body : event.despawn);
            const std::string& joint = event.release.empty() ? event.joint : event.release;
            const auto found = std::ranges::find(built.joints, joint, &SceneJointInstance::name);
            if (!joint.empty() && found != built.joints.end()) scheduled.joint = found->id;
            if (event.spawn) scheduled.plan = scene::plan_body(scene, *event.spawn);
        }
    }

    bool is_due(const ScheduledEvent& scheduled) const {
        const SceneEvent& event = scheduled.event;
        const double slack = scene::kTimeSlack / built.world.def().steps_per_second;
        const double now = built.world.time() + slack;
        if (event.at && scheduled.lasts()) return now >= *event.at && (!event.until || now < *event.until);
        if (event.at) return scheduled.count == 0 && now >= *event.at;
        const double due = event.from.value_or(0.0) + static_cast<double>(scheduled.count) * event.every.value_or(0.0);
        return now >= due && due <= event.until.value_or(std::numeric_limits<double>::infinity()) + slack;
    }

    void apply(ScheduledEvent& scheduled) {
        const SceneEvent& event = scheduled.event;
        World& world = built.world;
        if (event.gravity) world.set_gravity(to_float(*event.gravity));
        if (event.spawn) spawn(scheduled);
        if (scheduled.joint && world.is_valid(*scheduled.joint)) act_on_joint(event, *scheduled.joint);
        if (const SceneInstance* body = scheduled.body.find(built)) act_on_body(event, body->id);
        ++scheduled.count;
    }

    void act_on_body(const SceneEvent& event, BodyId body) {
        World& world = built.world;
        const BodyState state = world.state(body);
        if (event.impulse) world.apply_impulse(body, to_float(*event.impulse), center_of(world, body));
        if (event.angular_impulse) world.apply_angular_impulse(body, static_cast<float>(*event.angular_impulse));
        if (event.force) world.apply_force(body, to_float(*event.force), center_of(world, body));
        if (event.torque) world.apply_torque(body, static_cast<float>(*event.torque));
        if (event.velocity) world.set_velocity(body, to_float(*event.velocity), state.angular_velocity);
        if (event.angular_velocity)
            world.set_velocity(body, state.velocity, static_cast<float>(*event.angular_velocity * scene::kRadians));
        if (!event.despawn.empty()) world.destroy_body(body);
    }

    void act_on_joint(const SceneEvent& event, JointId joint) {
        World& world = built.world;
        JointDef def = world.joint(joint);
        if (event.motor_speed) set_motor_speed(def, *event.motor_speed);
        if (event.target) {
            auto& mouse = std::get<MouseJointDef>(def);
            mouse.anchor_a = to_float(inverse_transform_point(world.state(mouse.body_a).pose, *event.target));
        }
        if (event.release.empty())
            world.set_joint(joint, def);
        else
            world.destroy_joint(joint);
    }

    void spawn(ScheduledEvent& scheduled) {
        TUMBLE_CHECK(scheduled.plan.has_value());
        const SceneBody& body = *scheduled.event.spawn;
        const std::size_t source = bodies_of_file + scheduled.index;
        const bool is_one = !scheduled.event.every && !body.repeat;
        const std::int64_t count = static_cast<std::int64_t>(built.world.bodies().size()) + scene::copy_count(body);
        try {
            if (count > scene::kMaxBodies)
                throw std::invalid_argument("brings the number of bodies to " + std::to_string(count) + "; at most " +
                                            std::to_string(scene::kMaxBodies) + " are allowed");
            for (const scene::PlacedBody& copy : scene::place_copies(body, seed + scheduled.count, source)) {
                const BodyId id = scene::create_body(built.world, *scheduled.plan, copy.pose);
                built.bodies.push_back(
                    {id, source, is_one ? body.name : scene::copy_name(body.name, scheduled.spawned++)});
            }
        } catch (const std::invalid_argument& refusal) {
            scene::Diagnostics diagnostics(name.empty() ? "scene" : name, "");
            diagnostics.error("/timeline/" + std::to_string(scheduled.index) + "/spawn", refusal.what());
            diagnostics.finish(nullptr);
        }
    }

    SceneWorld built;
    std::vector<ScheduledEvent> events;
    std::string name;  // of the scene, for errors
    std::uint64_t seed = 0;
    std::size_t bodies_of_file = 0;  // how many entries Scene::bodies has
};

std::uint64_t nearest_step(double time, double steps_per_second) {
    return static_cast<std::uint64_t>(std::llround(time * steps_per_second));
}

std::uint64_t count_steps(const Scene& scene) {
    return nearest_step(scene.world.duration, scene.world.steps_per_second);
}

std::vector<std::uint64_t> steps_of_event(const SceneEvent& event, double steps_per_second, std::uint64_t last,
                                          std::size_t most) {
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
    for (ScheduledEvent& scheduled : impl_->events)
        if (impl_->is_due(scheduled)) impl_->apply(scheduled);
    try {
        impl_->built.world.step();
    } catch (const SimulationDiverged& error) {
        throw SimulationDiverged(error.body, error.step, scene::display_name(impl_->built, error.body));
    }
}

void SceneRun::set_threads(const Threads& threads) { impl_->built.world.set_threads(threads); }

std::vector<std::byte> SceneRun::save(const Scene& scene) const {
    scene::SavedRun saved{scene_hash(scene), impl_->built.bodies, {}, impl_->built.world.save()};
    for (const ScheduledEvent& event : impl_->events) saved.events.push_back({event.count, event.spawned});
    return scene::to_bytes(saved);
}

SceneRun SceneRun::load(const Scene& scene, std::span<const std::byte> saved) {
    scene::SavedRun read = scene::read_saved_run(saved);
    SceneRun run(scene);
    Impl& impl = *run.impl_;
    if (read.scene_hash != scene_hash(scene) || read.events.size() != impl.events.size())
        throw SnapshotError("the saved run is that of another scene");
    impl.built.world = World::load(read.world);
    impl.built.bodies = std::move(read.bodies);
    for (std::size_t i = 0; i < impl.events.size(); ++i) {
        impl.events[i].count = read.events[i].count;
        impl.events[i].spawned = read.events[i].spawned;
    }
    return run;
}

double SceneRun::time() const { return impl_->built.world.time(); }

World& SceneRun::world() noexcept { return impl_->built.world; }

const SceneWorld& SceneRun::built() const noexcept { return impl_->built; }

}  // namespace tumble
