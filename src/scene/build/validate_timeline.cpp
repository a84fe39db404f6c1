#include "scene/build/validate_timeline.hpp"

#include <stdexcept>

#include "scene/build/element.hpp"
#include "scene/build/resolve.hpp"
#include "scene/build/validate_body.hpp"
#include "scene/build/validate_expression.hpp"
#include "scene/json/json_text.hpp"
#include "scene/model/repeat.hpp"

namespace tumble::scene {

namespace {

class EventValidator {
public:
    EventValidator(const Scene& scene, const References& references, Diagnostics& diagnostics)
        : scene_(scene), references_(references), diagnostics_(diagnostics) {}

    void validate(const SceneEvent& event, const std::string& pointer) {
        if (diagnostics_.has_errors_in(pointer)) return;
        const bool lasts = event.force || event.torque;
        const bool on_body =
            lasts || event.impulse || event.angular_impulse || event.velocity || event.angular_velocity;
        const bool on_joint = event.motor_speed || event.target;
        validate_times(event, pointer, lasts);
        validate_when(event, pointer);
        if (on_body) references_.any_body(event.body, pointer, "body");
        if (on_body) validate_new_velocity(event, pointer);
        if (!on_body && !event.body.empty()) error(pointer + "/body", "belongs to impulses, forces and velocities");
        if (!event.despawn.empty()) references_.any_body(event.despawn, pointer, "despawn");
        if (on_joint) validate_joint(event, pointer);
        if (!on_joint && !event.joint.empty()) error(pointer + "/joint", "belongs to motor speeds and targets");
        if (!event.release.empty()) references_.joint(event.release, pointer, "release");
        if (event.spawn) validate_spawn(*event.spawn, pointer + "/spawn");
        if (!event.stop && !has_other_action(event)) error(pointer + "/stop", "must be true, got false");
        if (event.stop && event.every) error(pointer + "/every", "belongs to events that can repeat: a run ends once");
    }

    void validate_period(const SceneEvent& event, const std::string& pointer) {
        const double dt = 1.0 / scene_.world.steps_per_second;
        if (event.every && *event.every < dt && !diagnostics_.has_errors_in(pointer))
            error(pointer + "/every", "is shorter than a step of " + number_text(dt) + " s");
    }

private:
    void validate_times(const SceneEvent& event, const std::string& pointer, bool lasts) {
        if (event.every && (lasts || !event.despawn.empty() || !event.release.empty()))
            error(pointer + "/every",
                  "belongs to events that can repeat: a force or torque lasts, a despawn or release happens once");
        if (event.from && !event.every) error(pointer + "/from", "belongs to events with 'every'");
        if (event.from && event.until && *event.until < *event.from)
            error(pointer + "/until", "must not be before 'from'");
        if (event.until && !event.every && !lasts)
            error(pointer + "/until", "belongs to events with 'every', and to forces and torques");
        if (event.until && event.at && *event.until <= *event.at) error(pointer + "/until", "must be after 'at'");
    }

    void validate_when(const SceneEvent& event, const std::string& pointer) {
        if (!event.when.empty()) return validate_condition(event.when, pointer + "/when", references_, diagnostics_);
        if (event.delay) error(pointer + "/delay", "belongs to events with 'when'");
        if (event.frame) error(pointer + "/frame", "belongs to events with 'when'");
    }

    static bool has_other_action(const SceneEvent& event) {
        return event.impulse || event.angular_impulse || event.force || event.torque || event.velocity ||
               event.angular_velocity || event.motor_speed || event.target || event.gravity || event.spawn ||
               !event.despawn.empty() || !event.release.empty();
    }

    void validate_new_velocity(const SceneEvent& event, const std::string& pointer) {
        const SceneBody* body = references_.definition(event.body);
        if (!body || (!event.velocity && !event.angular_velocity)) return;
        if (body->type == BodyType::static_body)
            error(pointer + "/body", quoted(event.body) + " is static: its velocity cannot be set",
                  R"(a body of "type": "kinematic" moves at the velocity it is given)");
        else if (!body->enabled)
            error(pointer + "/body", quoted(event.body) + " is disabled: its velocity cannot be set");
    }

    void validate_joint(const SceneEvent& event, const std::string& pointer) {
        const SceneJoint* joint = references_.joint(event.joint, pointer, "joint");
        if (joint == nullptr) return;
        if (event.motor_speed && !joint->motor)
            error(pointer + "/joint", "the joint " + quoted(event.joint) + " has no motor");
        if (event.target && joint->type != SceneJointType::mouse)
            error(pointer + "/joint",
                  "only a mouse joint has a target; " + quoted(event.joint) + " is of another type");
    }

    void validate_spawn(const SceneBody& body, const std::string& pointer) {
        resolve_shapes(scene_, body, pointer, diagnostics_);
        validate_body(body, pointer, diagnostics_);
        if (copy_count(body) > kMaxBodies)
            return error(pointer + "/repeat", "spawns " + std::to_string(copy_count(body)) + " bodies; at most " +
                                                  std::to_string(kMaxBodies) + " are allowed");
        try {
            copy_poses(body, scene_.world.seed, 0);
        } catch (const std::invalid_argument& cause) {
            error(pointer + "/repeat", cause.what());
        }
    }

    void error(const std::string& pointer, const std::string& message, const std::string& hint = "") {
        diagnostics_.error(pointer, message, hint);
    }

    const Scene& scene_;
    const References& references_;
    Diagnostics& diagnostics_;
};

}  // namespace

void validate_timeline(const Scene& scene, const SceneSizes& own, const References& references,
                       Diagnostics& diagnostics) {
    EventValidator validator(scene, references, diagnostics);
    for (std::size_t i = 0; i < own.timeline; ++i) validator.validate(scene.timeline[i], element("/timeline", i));
    // Included events are validated again: the steps of their own scene may be shorter.
    for (std::size_t i = 0; i < scene.timeline.size(); ++i)
        validator.validate_period(scene.timeline[i], element("/timeline", i));
}

}  // namespace tumble::scene
