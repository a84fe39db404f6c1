#include "render/replay/event_marks.hpp"

#include <algorithm>
#include <limits>

#include "tumble/scene_run.hpp"

namespace tumble::render {

namespace {

std::string quoted(const std::string& name) { return "'" + name + "'"; }

std::string text_of(const SceneEvent& event) {
    if (event.spawn) return "new body " + quoted(event.spawn->name);
    if (!event.despawn.empty()) return "body " + quoted(event.despawn) + " is removed";
    if (!event.release.empty()) return "joint " + quoted(event.release) + " is released";
    if (event.stop) return "the run ends";
    if (event.gravity) return "gravity changes";
    if (event.motor_speed) return "motor speed of " + quoted(event.joint);
    if (event.target) return "target of " + quoted(event.joint);
    const bool is_impulse = event.impulse || event.angular_impulse, is_force = event.force || event.torque;
    return (is_impulse ? "impulse on " : is_force ? "force on " : "velocity of ") + quoted(event.body);
}

// The first state with the effect of an event that is applied before a step.
std::uint64_t first_state(const SceneEvent& event, std::uint64_t step) { return event.stop ? step : step + 1; }

}  // namespace

std::vector<EventMark> timeline_marks(const Scene& scene) {
    constexpr std::uint64_t kNoLast = std::numeric_limits<std::uint64_t>::max();
    std::vector<EventMark> marks;
    for (const SceneEvent& event : scene.timeline)
        for (const std::uint64_t step : steps_of_event(event, scene.world.steps_per_second, kNoLast, kMostRepetitions))
            marks.push_back({first_state(event, step), text_of(event)});
    std::ranges::stable_sort(marks, {}, &EventMark::step);
    return marks;
}

ConditionMarks::ConditionMarks(const Scene& scene) : steps_per_second_(scene.world.steps_per_second) {
    for (const SceneEvent& event : scene.timeline)
        if (!event.when.empty())
            awaited_.push_back({event, Expression(event.when, scene, event.frame.value_or(SceneFrame{}))});
}

void ConditionMarks::record(const SceneWorld& built) {
    const auto holds = [&](const Awaited& awaited) {
        if (!awaited.condition.holds(built)) return false;
        SceneEvent due = awaited.event;
        due.when.clear();
        due.at = static_cast<double>(built.world.step_count()) / steps_per_second_ + due.delay.value_or(0.0);
        constexpr std::uint64_t kNoLast = std::numeric_limits<std::uint64_t>::max();
        for (const std::uint64_t step : steps_of_event(due, steps_per_second_, kNoLast, 1))
            marks_.push_back({first_state(due, step), text_of(due)});
        return true;
    };
    std::erase_if(awaited_, holds);
}

void BrokenJoints::record(const SceneWorld& built) {
    for (const JointId id : built.world.events().broken_joints)
        for (std::size_t i = 0; i < built.joints.size(); ++i)
            if (built.joints[i].id == id)
                marks_.push_back(
                    {built.world.step_count(), "joint " + quoted(output_name(built.joints[i], i)) + " breaks"});
}

}  // namespace tumble::render
