#include "render/replay/event_marks.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::render {

namespace {

std::string quoted(const std::string& name) { return "'" + name + "'"; }

std::string text_of(const SceneEvent& event) {
    if (event.spawn) return "new body " + quoted(event.spawn->name);
    if (!event.despawn.empty()) return "body " + quoted(event.despawn) + " is removed";
    if (!event.release.empty()) return "joint " + quoted(event.release) + " is released";
    if (event.gravity) return "gravity changes";
    if (event.motor_speed) return "motor speed of " + quoted(event.joint);
    if (event.target) return "target of " + quoted(event.joint);
    const bool is_impulse = event.impulse || event.angular_impulse, is_force = event.force || event.torque;
    return (is_impulse ? "impulse on " : is_force ? "force on " : "velocity of ") + quoted(event.body);
}

// The first step that begins at `time` or later. A time within rounding of a step's begin is that of the step.
std::uint64_t step_from(double time, double steps_per_second) {
    constexpr double kRounding = 1e-9;  // steps
    return static_cast<std::uint64_t>(std::ceil(std::max(0.0, time * steps_per_second - kRounding)));
}

}  // namespace

std::vector<EventMark> timeline_marks(const Scene& scene, std::uint64_t last_step) {
    std::vector<EventMark> marks;
    const double rate = scene.world.steps_per_second;
    for (const SceneEvent& event : scene.timeline) {
        const double first = event.every ? event.from.value_or(0.0) : event.at.value_or(0.0);
        const int count = event.every ? kMostRepetitions : 1;
        for (int i = 0; i < count; ++i) {
            const double time = first + i * event.every.value_or(0.0);
            const std::uint64_t step = step_from(time, rate) + 1;
            if (step > last_step || (event.every && time > event.until.value_or(time))) break;
            marks.push_back({step, text_of(event)});
        }
    }
    std::ranges::stable_sort(marks, {}, &EventMark::step);
    return marks;
}

void BrokenJoints::record(const SceneWorld& built) {
    for (const JointId id : built.world.events().broken_joints)
        for (std::size_t i = 0; i < built.joints.size(); ++i)
            if (built.joints[i].id == id)
                marks_.push_back(
                    {built.world.step_count(), "joint " + quoted(output_name(built.joints[i], i)) + " breaks"});
}

}  // namespace tumble::render
