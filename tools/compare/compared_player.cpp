#include "tools/compare/compared_player.hpp"

#include <algorithm>

#include "tools/cli/console.hpp"
#include "tumble/recording.hpp"

namespace tumble::tools {

namespace {

ReplayPair described(const ReplayRecorder& a, const ReplayRecorder& b, const std::string& name,
                     const ComparedRuns& runs) {
    ReplayPair pair{a, b, name, runs.name_a, runs.name_b};
    if (runs.comparison.first && runs.comparison.first->step <= runs.steps.back().step)
        pair.first_difference = runs.comparison.first->step;
    for (const ComparedStep& step : runs.steps) {
        pair.distances.push_back(step.largest[kPosition].value);
        pair.energies_a.push_back(step.energy_a);
        pair.energies_b.push_back(step.energy_b);
    }
    return pair;
}

}  // namespace

std::string compared_player(const CompareInputs& inputs, const ComparedRuns& runs, const PairPictures& pictures) {
    const ComparedSources sources = open_sources(inputs);
    const SceneWorld *const a = sources.a->built(), *const b = sources.b->built();
    if (runs.steps.empty() || !a || !b) return "";
    const ReplaySettings settings{
        .aspect_ratio = pictures.size.aspect_ratio(), .contacts = false, .theme = pictures.overlay.theme};
    ReplayRecorder recorded_a(*sources.a->scene(), settings), recorded_b(*sources.b->scene(), settings);
    Camera camera = make_camera(*sources.a->scene(), *a, settings.aspect_ratio);
    StepStates states;
    Progress progress("steps recorded", runs.steps.size());
    for (const ComparedStep& step : runs.steps) {
        if (!sources.a->next(states) || !sources.b->next(states)) break;
        if (step.step > 0) camera = move_camera(camera, *sources.a->scene(), *a);
        const Camera shown = apply_camera_keys(camera, *sources.a->scene(), *a, settings.aspect_ratio);
        recorded_a.record_as(step.step, *a, shown);
        recorded_b.record_as(step.step, *b, shown);
        progress.show(step.step);
        if (!recorded_a.is_whole() || !recorded_b.is_whole()) return "";
    }
    return pair_page(described(recorded_a, recorded_b, sources.a->scene()->name, runs));
}

}  // namespace tumble::tools
