#include "tools/compare/compared_player.hpp"

#include <algorithm>

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

std::string compared_player(const CompareInputs& inputs, const ComparedRuns& runs, FrameSize size) {
    const ComparedSources sources = open_sources(inputs);
    const SceneWorld *const a = sources.a->built(), *const b = sources.b->built();
    if (runs.steps.empty() || !a || !b) return "";
    const ReplaySettings settings{.aspect_ratio = size.aspect_ratio(), .contacts = false};
    ReplayRecorder recorded_a(*sources.a->scene(), settings), recorded_b(*sources.b->scene(), settings);
    Camera camera = make_camera(*sources.a->scene(), *a, settings.aspect_ratio);
    StepStates states;
    for (const ComparedStep& step : runs.steps) {
        if (!sources.a->next(states) || !sources.b->next(states)) break;
        if (step.step > 0) camera = move_camera(camera, *sources.a->scene(), *a);
        recorded_a.record_as(step.step, *a, camera);
        recorded_b.record_as(step.step, *b, camera);
        if (!recorded_a.is_whole() || !recorded_b.is_whole()) return "";
    }
    return pair_page(described(recorded_a, recorded_b, sources.a->scene()->name, runs));
}

}  // namespace tumble::tools
