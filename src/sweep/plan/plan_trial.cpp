#include "sweep/plan/plan_trial.hpp"

#include <optional>
#include <string_view>

#include "scene/json/pointer.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::sweep {

namespace {

// The pointer in the plan of the parameter or setting that makes a change of the scene.
std::string pointer_of_change(const Plan& plan, const std::string& argument) {
    for (std::size_t i = 0; i < plan.parameters.size(); ++i)
        for (const std::string& pointer : plan.parameters[i].pointers)
            if (argument == "--set " + pointer || argument.starts_with("--set " + pointer + "="))
                return "/parameters/" + std::to_string(i) + "/set";
    for (const std::string& setting : plan.settings)
        if (argument == "--set " + setting) return scene::append_key("/set", setting.substr(0, setting.find('=')));
    return argument.starts_with("--seed") ? "/seeds" : "";
}

std::optional<Scene> try_run(const Plan& plan, const RunChoice& choice, scene::Diagnostics& diagnostics) {
    LoadOptions changes;
    changes.overrides = overrides_of(plan, choice);
    changes.seed = choice.seed;
    changes.allow_outside = plan.allow_outside;
    try {
        return load_scene(scene_file(plan, choice.scene), changes);
    } catch (const SceneError& error) {
        for (const Diagnostic& diagnostic : error.diagnostics) {
            if (!diagnostic.is_of_argument) throw;
            diagnostics.error(pointer_of_change(plan, diagnostic.file), diagnostic.file + ": " + diagnostic.message,
                              diagnostic.hint);
        }
    } catch (const FileError& error) {
        diagnostics.error(pointer_of_scene(plan, choice.scene), error.what(),
                          "paths are relative to the folder of the plan");
    }
    return std::nullopt;
}

void try_expression(const std::string& text, const std::string& pointer, const Scene& scene,
                    std::span<const std::string> names, bool is_condition, scene::Diagnostics& diagnostics) {
    try {
        const Expression expression(text, scene, {}, names);
        if (is_condition && expression.kind() != Expression::Kind::condition)
            diagnostics.error(pointer, "is a number, and must be a condition");
    } catch (const ExpressionError& error) {
        diagnostics.error_in_text(pointer, error.offset, error.what(), error.hint);
    }
}

void try_expressions(const Plan& plan, const Scene& scene, scene::Diagnostics& diagnostics) {
    std::vector<std::string> names;
    for (const Parameter& parameter : plan.parameters) names.push_back(parameter.name);
    for (std::size_t i = 0; i < plan.measures.size(); ++i)
        try_expression(plan.measures[i].expression, "/measures/" + std::to_string(i) + "/value", scene, names, false,
                       diagnostics);
    if (!plan.filter.that.empty()) try_expression(plan.filter.that, "/filter/that", scene, names, true, diagnostics);
}

SceneFacts facts_of(const Scene& scene) {
    const bool has_camera = scene.camera.height && (scene.camera.center || !scene.camera.follow.empty());
    return {!scene.expect.empty(), has_camera};
}

}  // namespace

std::string pointer_of_scene(const Plan& plan, std::size_t scene) {
    return plan.scenes.size() > 1 ? "/scenes/" + std::to_string(scene) : "/scene";
}

TriedScenes try_first_runs(const Plan& plan, scene::Diagnostics& diagnostics) {
    TriedScenes tried;
    // Scenes are the outermost dimension of the grid.
    const std::uint64_t runs_of_scene = grid_size(plan) / plan.scenes.size();
    for (std::size_t i = 0; i < plan.scenes.size() && !diagnostics.has_errors(); ++i) {
        const std::optional<Scene> scene = try_run(plan, choose_run(plan, i * runs_of_scene), diagnostics);
        if (!scene) continue;
        try_expressions(plan, *scene, diagnostics);
        tried.texts += to_json(*scene);
        tried.facts.push_back(facts_of(*scene));
    }
    return tried;
}

}  // namespace tumble::sweep
