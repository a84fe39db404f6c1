// Lints of events and claims after the end of the run, and of events without effect.
#include <cstdint>
#include <string>

#include "scene/json/json_text.hpp"
#include "scene/json/problem_codes.hpp"
#include "scene/lint/lint.hpp"
#include "scene/model/names.hpp"
#include "scene/model/step_time.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::scene {

namespace {

class RunLinter {
public:
    RunLinter(const Scene& scene, Diagnostics& diagnostics)
        : scene_(scene), diagnostics_(diagnostics), names_(scene), steps_(count_steps(scene)) {}

    void lint_event(const SceneEvent& event, const std::string& pointer) {
        // An event at the time of the last state has no effect: no step begins there.
        if (event.at) lint_time(*event.at, 1, pointer + "/at", "the event never happens");
        if (event.from) lint_time(*event.from, 1, pointer + "/from", "the event never happens");
        lint_push(event, pointer);
        if (!event.when.empty()) return;  // its time is not known
        const double time = event.at.value_or(event.from.value_or(0.0));
        if (!names_.is_spawned(event.body)) lint_removed(event.body, time, &SceneEvent::despawn, pointer + "/body");
        lint_removed(event.joint, time, &SceneEvent::release, pointer + "/joint");
    }

    void lint_claim(const SceneExpectation& claim, const std::string& pointer) {
        const std::string consequence = "the claim cannot hold";
        if (claim.at) lint_time(*claim.at, 0, pointer + "/at", consequence);
        if (claim.at_rest_by) lint_time(*claim.at_rest_by, 0, pointer + "/at_rest_by", consequence);
        if (claim.from) lint_time(*claim.from, 0, pointer + "/from", consequence);
    }

private:
    // Times that are less than `margin` steps before the last state are too late.
    void lint_time(double time, std::uint64_t margin, const std::string& pointer, const std::string& consequence) {
        if (first_step_at(time, scene_.world.steps_per_second) + margin <= steps_) return;
        diagnostics_.warning(codes::after_the_end, pointer,
                             "the run ends at " + number_text(scene_.world.duration) + " s: " + consequence,
                             R"(choose an earlier time, or a longer "duration" of the world)");
    }

    void lint_push(const SceneEvent& event, const std::string& pointer) {
        const SceneBody* body = find_definition(scene_, names_, event.body);
        const bool pushes = event.impulse || event.angular_impulse || event.force || event.torque;
        if (!pushes || body == nullptr || body->type == BodyType::dynamic_body) return;
        const bool is_static = body->type == BodyType::static_body;
        diagnostics_.warning(
            codes::useless_force, pointer + "/body",
            quoted(event.body) + " is " + (is_static ? "static" : "kinematic") + ": forces and impulses do not move it",
            is_static ? R"(make it "dynamic")" : R"(set its "velocity", or make it "dynamic")");
    }

    // Warns if the body or joint of that name is removed before the time. `removed` is the member of an event that
    // names what it removes.
    void lint_removed(const std::string& name, double time, std::string SceneEvent::*removed,
                      const std::string& pointer) {
        for (const SceneEvent& end : scene_.timeline) {
            if (name.empty() || end.*removed != name || !end.at || time <= *end.at) continue;
            diagnostics_.warning(
                codes::event_after_removal, pointer,
                quoted(name) + " is removed at " + number_text(*end.at) + " s: a later event has no effect on it",
                "choose an earlier time for the event, or remove it later");
            return;
        }
    }

    const Scene& scene_;
    Diagnostics& diagnostics_;
    BodyNames names_;
    std::uint64_t steps_ = 0;  // of the run
};

}  // namespace

void add_run_lints(const Scene& scene, Diagnostics& diagnostics) {
    RunLinter linter(scene, diagnostics);
    for (std::size_t i = 0; i < scene.timeline.size(); ++i)
        linter.lint_event(scene.timeline[i], "/timeline/" + std::to_string(i));
    for (std::size_t i = 0; i < scene.expect.size(); ++i)
        linter.lint_claim(scene.expect[i], "/expect/" + std::to_string(i));
}

}  // namespace tumble::scene
