// Events and claims that the run never comes to, and events that nothing obeys.
#include <cstdint>
#include <string>

#include "scene/json/json_text.hpp"
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

    void check_event(const SceneEvent& event, const std::string& pointer) {
        // An event of the last state comes too late too: no step begins there.
        if (event.at) check_time(*event.at, 1, pointer + "/at", "it never happens");
        if (event.from) check_time(*event.from, 1, pointer + "/from", "it never happens");
        check_obeyed(event, pointer);
        const double time = event.at.value_or(event.from.value_or(0.0));
        if (!names_.is_spawned(event.body)) check_gone(event.body, time, &SceneEvent::despawn, pointer + "/body");
        check_gone(event.joint, time, &SceneEvent::release, pointer + "/joint");
    }

    void check_claim(const SceneExpectation& claim, const std::string& pointer) {
        const std::string consequence = "it cannot hold";
        if (claim.at) check_time(*claim.at, 0, pointer + "/at", consequence);
        if (claim.at_rest_by) check_time(*claim.at_rest_by, 0, pointer + "/at_rest_by", consequence);
        if (claim.from) check_time(*claim.from, 0, pointer + "/from", consequence);
    }

private:
    // `margin` steps before the last state are too late.
    void check_time(double time, std::uint64_t margin, const std::string& pointer, const std::string& consequence) {
        if (first_step_at(time, scene_.world.steps_per_second) + margin <= steps_) return;
        diagnostics_.warning(pointer, "the run ends at " + number_text(scene_.world.duration) + " s: " + consequence,
                             R"(an earlier time, or a longer "duration" of the world)");
    }

    void check_obeyed(const SceneEvent& event, const std::string& pointer) {
        const SceneBody* body = find_definition(scene_, names_, event.body);
        const bool pushes = event.impulse || event.angular_impulse || event.force || event.torque;
        if (!pushes || body == nullptr || body->type == BodyType::dynamic_body) return;
        const bool is_static = body->type == BodyType::static_body;
        diagnostics_.warning(
            pointer + "/body",
            quoted(event.body) + " is " + (is_static ? "static" : "kinematic") + ": no force and no impulse moves it",
            is_static ? R"("type": "dynamic" is pushed about)" : R"(set its "velocity", or make it "dynamic")");
    }

    // Of the body or joint of that name, which something that `goes` takes away for good.
    void check_gone(const std::string& name, double time, std::string SceneEvent::*goes, const std::string& pointer) {
        for (const SceneEvent& end : scene_.timeline) {
            if (name.empty() || end.*goes != name || time <= end.at.value()) continue;
            diagnostics_.warning(
                pointer, quoted(name) + " goes at " + number_text(*end.at) + " s: nothing happens to it after that",
                "an earlier time, or let it go later");
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
        linter.check_event(scene.timeline[i], "/timeline/" + std::to_string(i));
    for (std::size_t i = 0; i < scene.expect.size(); ++i)
        linter.check_claim(scene.expect[i], "/expect/" + std::to_string(i));
}

}  // namespace tumble::scene
