#include "scene/run/timeline_run.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <unordered_map>

#include "debug/check.hpp"
#include "scene/expressions/evaluate.hpp"
#include "scene/json/diagnostics.hpp"
#include "scene/model/degrees.hpp"
#include "scene/model/frame.hpp"
#include "scene/model/place_copies.hpp"
#include "scene/model/repeat.hpp"
#include "scene/model/step_time.hpp"

namespace tumble::scene {

namespace {

using ConditionKey = std::tuple<std::string, double, double, double>;  // its text, and the frame of its coordinates

// Does nothing if the joint has no motor.
void set_motor_speed(JointDef& joint, double speed) {
    std::visit(
        [speed](auto& def) {
            if constexpr (requires { def.motor; }) {
                if (!def.motor) return;
                const bool turns = std::is_same_v<std::decay_t<decltype(*def.motor)>, AngularMotor>;
                def.motor->speed = static_cast<float>(turns ? speed * kRadians : speed);
            }
        },
        joint);
}

DVec2 center_of(const World& world, BodyId body) {
    return transform_point(world.state(body).pose, world.mass(body).center);
}

double slack(const World& world) { return kTimeSlack / world.def().steps_per_second; }  // s

// Events up to this time are due before the next step, s.
double due_until(const World& world) { return world.time() + slack(world); }

// The next repetition of an event that has `every`, s.
double next_repetition(const ScheduledEvent& scheduled) {
    const SceneEvent& event = scheduled.event;
    return event.from.value_or(0.0) + static_cast<double>(scheduled.state.count) * event.every.value_or(0.0);
}

// Whether an event has a repetition at this time, s: `until` is not before it.
bool repeats_at(const SceneEvent& event, double time, const World& world) {
    return time <= event.until.value_or(std::numeric_limits<double>::infinity()) + slack(world);
}

bool repeats(const SceneEvent& event) { return event.when.empty() && !event.at; }

// When an event that does not wait for its condition is due, or due next, s.
double due_time(const ScheduledEvent& scheduled, const World& world) {
    const SceneEvent& event = scheduled.event;
    TUMBLE_CHECK(!scheduled.is_waiting());
    if (repeats(event)) return next_repetition(scheduled);
    if (event.at) return *event.at;
    return static_cast<double>(scheduled.state.held - 1) / world.def().steps_per_second + event.delay.value_or(0.0);
}

bool is_due(const ScheduledEvent& scheduled, const World& world) {
    const SceneEvent& event = scheduled.event;
    const double due = due_time(scheduled, world), now = due_until(world);
    if (now < due) return false;
    if (repeats(event)) return repeats_at(event, due, world);
    return scheduled.lasts() ? !event.until || now < *event.until : scheduled.state.count == 0;
}

// Whether an event can never be due again. A stop never is over: it is not counted.
bool is_over(const ScheduledEvent& scheduled, const World& world) {
    const SceneEvent& event = scheduled.event;
    if (event.every) return !repeats_at(event, next_repetition(scheduled), world);
    if (scheduled.lasts()) return event.until && due_until(world) >= *event.until;
    return scheduled.state.count > 0;
}

// The first instance of each name.
std::unordered_map<std::string_view, std::size_t> first_instances(const SceneWorld& built) {
    std::unordered_map<std::string_view, std::size_t> first;
    for (std::size_t i = 0; i < built.bodies.size(); ++i) first.try_emplace(built.bodies[i].name, i);
    return first;
}

// The energy of a body, 0 if it was destroyed, J.
double energy_of(const World& world, BodyId body) { return world.is_valid(body) ? world.energy(body).total() : 0.0; }

// Calls act(), and adds to the work what it changes of energy(), J.
template <class Energy, class Act>
void act_and_add_work(SceneWorld& built, Energy&& energy, Act&& act) {
    const double before = energy();
    act();
    built.work += energy() - before;
}

void act_on_body(World& world, const SceneEvent& event, BodyId body) {
    const BodyState state = world.state(body);
    if (event.impulse) world.apply_impulse(body, to_float(*event.impulse), center_of(world, body));
    if (event.angular_impulse) world.apply_angular_impulse(body, static_cast<float>(*event.angular_impulse));
    if (event.force) world.apply_force(body, to_float(*event.force), center_of(world, body));
    if (event.torque) world.apply_torque(body, static_cast<float>(*event.torque));
    if (event.velocity) world.set_velocity(body, to_float(*event.velocity), state.angular_velocity);
    if (event.angular_velocity)
        world.set_velocity(body, state.velocity, static_cast<float>(*event.angular_velocity * kRadians));
    if (!event.despawn.empty()) world.destroy_body(body);
}

void act_on_joint(World& world, const SceneEvent& event, JointId joint) {
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

}  // namespace

TimelineRun::TimelineRun(const Scene& scene, SceneWorld& built)
    : scene_name_(scene.name), seed_(scene.world.seed), bodies_of_file_(scene.bodies.size()) {
    const bool has_conditions =
        std::ranges::any_of(scene.timeline, [](const SceneEvent& event) { return !event.when.empty(); });
    const BodyNames bodies(has_conditions ? scene : Scene{});
    const JointNames joints(has_conditions ? scene : Scene{});
    const KnownNames names{scene, bodies, joints};
    const auto first = first_instances(built);
    std::map<ConditionKey, std::size_t> entries;  // of conditions_
    for (std::size_t i = 0; i < scene.timeline.size(); ++i) {
        const SceneEvent& event = scene.timeline[i];
        ScheduledEvent& scheduled = events_.emplace_back();
        scheduled.event = event;
        scheduled.index = i;
        const std::string& body = event.despawn.empty() ? event.body : event.despawn;
        const auto instance = first.find(body);
        scheduled.body = BodyLookup(body, instance == first.end() ? built.bodies.size() : instance->second);
        const std::string& joint = event.release.empty() ? event.joint : event.release;
        const auto found = std::ranges::find(built.joints, joint, &SceneJointInstance::name);
        if (!joint.empty() && found != built.joints.end()) scheduled.joint = found->id;
        if (event.spawn) scheduled.plan = plan_body(scene, *event.spawn);
        if (event.when.empty()) continue;
        const SceneFrame frame = event.frame.value_or(SceneFrame{});
        const auto [entry, is_new] = entries.try_emplace(
            ConditionKey{event.when, frame.position.x, frame.position.y, frame.angle}, conditions_.size());
        if (is_new) conditions_.push_back({compile_condition(event.when, &names, frame)});
        conditions_[entry->second].events.push_back(i);
    }
    open_events(built.world);
    watch(built);
}

void TimelineRun::open_events(const World& world) {
    open_.clear();
    for (const ScheduledEvent& scheduled : events_)
        if (!scheduled.is_waiting()) open_.push_back({scheduled.index, due_time(scheduled, world)});
    for (Condition& condition : conditions_)
        condition.has_held =
            std::ranges::none_of(condition.events, [&](std::size_t event) { return events_[event].is_waiting(); });
}

void TimelineRun::apply_due(SceneWorld& built) {
    const double now = due_until(built.world);
    for (OpenEvent& open : open_) {
        if (now < open.due) continue;
        ScheduledEvent& scheduled = events_[open.index];
        if (!scheduled.event.stop && is_due(scheduled, built.world)) apply(scheduled, built);
        open.due = due_time(scheduled, built.world);
    }
    std::erase_if(open_, [&](OpenEvent open) { return now >= open.due && is_over(events_[open.index], built.world); });
    for (Push& push : pushes_) {
        push.center = center_of(built.world, push.body);
        push.rotation = built.world.state(push.body).pose.rotation;
    }
}

void TimelineRun::add_work(SceneWorld& built) {
    for (const Push& push : pushes_) {
        if (built.world.type(push.body) != BodyType::dynamic_body) continue;
        const Rotation rotation = built.world.state(push.body).pose.rotation;
        built.work += dot(push.force, center_of(built.world, push.body) - push.center) +
                      push.torque * angle(rotation_between(push.rotation, rotation));
    }
    pushes_.clear();
}

void TimelineRun::watch(const SceneWorld& built) {
    const std::size_t before = open_.size();
    for (Condition& condition : conditions_) {
        if (condition.has_held || !holds(condition.program, built)) continue;
        condition.has_held = true;
        for (const std::size_t index : condition.events) {
            if (!events_[index].is_waiting()) continue;
            events_[index].state.held = 1 + built.world.step_count();
            open_.push_back({index, due_time(events_[index], built.world)});
        }
    }
    if (open_.size() > before) std::ranges::sort(open_, {}, &OpenEvent::index);
}

bool TimelineRun::is_stopped(const SceneWorld& built) const {
    const double now = due_until(built.world);
    return std::ranges::any_of(open_, [&](OpenEvent open) {
        return now >= open.due && events_[open.index].event.stop && is_due(events_[open.index], built.world);
    });
}

// The work is what changes the energy of bodies. Joints have none, and bodies that wake keep theirs.
void TimelineRun::apply(ScheduledEvent& scheduled, SceneWorld& built) {
    const SceneEvent& event = scheduled.event;
    World& world = built.world;
    if (event.gravity)
        act_and_add_work(
            built, [&] { return world.energy().total(); }, [&] { world.set_gravity(to_float(*event.gravity)); });
    if (event.spawn) spawn(scheduled, built);
    if (scheduled.joint && world.is_valid(*scheduled.joint)) act_on_joint(world, event, *scheduled.joint);
    if (const SceneInstance* body = scheduled.body.find(built)) {
        const BodyId id = body->id;
        act_and_add_work(
            built, [&] { return energy_of(world, id); }, [&] { act_on_body(world, event, id); });
        if (scheduled.lasts())
            pushes_.push_back(
                {.body = id, .force = event.force.value_or(DVec2{}), .torque = event.torque.value_or(0.0)});
        else if (!event.despawn.empty())
            std::erase_if(pushes_, [&](const Push& push) { return push.body == id; });
    }
    ++scheduled.state.count;
}

void TimelineRun::spawn(ScheduledEvent& scheduled, SceneWorld& built) {
    TUMBLE_CHECK(scheduled.plan.has_value());
    const SceneBody& body = *scheduled.event.spawn;
    const std::size_t source = bodies_of_file_ + scheduled.index;
    const bool is_one = !scheduled.event.every && !body.repeat;
    const std::int64_t count = static_cast<std::int64_t>(built.world.bodies().size()) + copy_count(body);
    try {
        if (count > kMaxBodies)
            throw std::invalid_argument("brings the number of bodies to " + std::to_string(count) + "; at most " +
                                        std::to_string(kMaxBodies) + " are allowed");
        for (const PlacedBody& copy : place_copies(body, seed_ + scheduled.state.count, source)) {
            const BodyId id = create_body(built.world, *scheduled.plan, copy.pose);
            built.work += energy_of(built.world, id);
            built.bodies.push_back({id, source, is_one ? body.name : copy_name(body.name, scheduled.state.spawned++)});
        }
    } catch (const std::invalid_argument& refusal) {
        Diagnostics diagnostics(scene_name_.empty() ? "scene" : scene_name_, "");
        diagnostics.error("/timeline/" + std::to_string(scheduled.index) + "/spawn", refusal.what());
        diagnostics.finish(nullptr);
    }
}

std::vector<SavedEvent> TimelineRun::state() const {
    std::vector<SavedEvent> states;
    for (const ScheduledEvent& scheduled : events_) states.push_back(scheduled.state);
    return states;
}

bool TimelineRun::set_state(const std::vector<SavedEvent>& state, const World& world) {
    if (state.size() != events_.size()) return false;
    for (std::size_t i = 0; i < state.size(); ++i) events_[i].state = state[i];
    open_events(world);
    return true;
}

}  // namespace tumble::scene
