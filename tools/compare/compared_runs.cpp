#include "tools/compare/compared_runs.hpp"

#include <filesystem>
#include <utility>

#include "tools/cli/console.hpp"
#include "tools/compare/box2d_states.hpp"
#include "tools/machine/engines.hpp"
#include "tools/output/json_writer.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

ComparedSources open_sources(const CompareInputs& inputs) {
    ComparedSources sources;
    sources.a = open_states(inputs.a, inputs.changes_a);
    if (inputs.b.empty()) {
        auto box2d = std::make_unique<Box2dStates>(*sources.a->scene());
        sources.notes = box2d->notes();
        sources.b = std::move(box2d);
        const std::array<EngineBuild, 2> engines = compared_engines();
        sources.name_a = engines[0].name + " " + engines[0].version;
        sources.name_b = engines[1].name + " " + engines[1].version;
        return sources;
    }
    sources.b = open_states(inputs.b, inputs.changes_b);
    sources.name_a = "A: " + inputs.a;
    sources.name_b = "B: " + inputs.b;
    return sources;
}

ComparedRuns compare_runs(const CompareInputs& inputs, double tolerance) {
    ComparedSources sources = open_sources(inputs);
    ComparedRuns runs{std::move(sources.name_a), std::move(sources.name_b), std::move(sources.notes), {}, {}};
    const Scene* const scene = sources.a->scene();  // of a table the number of steps is not known
    Progress progress("steps compared", scene ? count_steps(*scene) : 0);
    const StepObserver observe = [&](double time, std::uint64_t step, const StepDifference& largest) {
        runs.steps.push_back({step, time, largest, sources.a->energy(), sources.b->energy()});
        if (scene) progress.show(step);
    };
    runs.comparison = compare_states(*sources.a, *sources.b, tolerance, observe);
    return runs;
}

const ComparedStep* first_beyond(const ComparedRuns& runs, std::size_t kind, double bound) {
    for (const ComparedStep& step : runs.steps)
        if (step.largest[kind].value > bound) return &step;
    return nullptr;
}

std::string to_csv(const ComparedRuns& runs) {
    std::string text = "step,time,position,angle,velocity,angular_velocity,energy_a,energy_b\n";
    for (const ComparedStep& step : runs.steps) {
        text += std::to_string(step.step) + ",";
        append_number(text, step.time);
        for (const LargestDifference& largest : step.largest) append_number(text += ",", largest.value);
        append_number(text += ",", step.energy_a);
        append_number(text += ",", step.energy_b);
        text += "\n";
    }
    return text;
}

}  // namespace tumble::tools
