#include "sweep/plan/plan_lints.hpp"

#include <algorithm>
#include <cctype>

namespace tumble::sweep {

namespace {

constexpr std::uint64_t kManyFiles = 10000;  // in one folder

void warn(scene::Diagnostics& diagnostics, const std::string& pointer, const std::string& message,
          const std::string& hint) {
    diagnostics.warning({}, pointer, message, hint);
}

// Whether an expression has the name, and not only as a part of another.
bool has_name(const std::string& expression, const std::string& name) {
    const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    for (std::size_t at = expression.find(name); at != std::string::npos; at = expression.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        const bool begins = at == 0 || (!is_part(expression[at - 1]) && expression[at - 1] != '.');
        if (begins && (end == expression.size() || !is_part(expression[end]))) return true;
    }
    return false;
}

void lint_parameters(const Plan& plan, scene::Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
        const Parameter& parameter = plan.parameters[i];
        const auto uses = [&](const Measure& measure) { return has_name(measure.expression, parameter.name); };
        if (!parameter.pointers.empty() || has_name(plan.filter.that, parameter.name) ||
            std::ranges::any_of(plan.measures, uses))
            continue;
        warn(diagnostics, "/parameters/" + std::to_string(i) + "/name",
             "nothing depends on '" + parameter.name + "': it sets no value, and no measure or filter names it",
             "\"set\" states the JSON pointer of the scene that gets the value");
    }
}

void lint_runs(const Plan& plan, scene::Diagnostics& diagnostics) {
    const std::uint64_t grid = grid_size(plan);
    if (plan.slices % grid != 0)
        warn(diagnostics, "/runs",
             "is no multiple of the " + std::to_string(grid) +
                 " points of the grid, so that the first ones have a run more than the last",
             "without \"runs\" each point has one run");
    if (!plan.states_runs && !std::ranges::all_of(plan.parameters, &Parameter::is_on_grid))
        warn(diagnostics, "",
             std::string(grid == 1 ? "the plan makes one run" : "each point of the grid has one run") +
                 ", with one value of each parameter that is drawn",
             "\"runs\" states how many");
    const std::uint64_t files =
        shard_count(plan) * (std::uint64_t{plan.write.has_tar()} + std::uint64_t{plan.write.has_hdf5()} + 1);
    if (files > kManyFiles)
        warn(diagnostics, plan.shard_runs > 0 ? "/shard_runs" : "",
             "the folder will have " + std::to_string(files) + " files while the sweep runs",
             "\"shard_runs\" makes larger shards");
}

}  // namespace

void add_plan_lints(const Plan& plan, const std::vector<SceneFacts>& scenes, scene::Diagnostics& diagnostics) {
    lint_parameters(plan, diagnostics);
    lint_runs(plan, diagnostics);
    if (plan.filter.claims && std::ranges::none_of(scenes, &SceneFacts::has_claims))
        warn(diagnostics, "/filter/claims", "no scene has claims, so that this keeps every run",
             "claims are in the scene's \"expect\"");
    if (plan.write.has_pictures() && !std::ranges::all_of(scenes, &SceneFacts::has_camera))
        warn(diagnostics, plan.write.has_frames() ? "/write/frames" : "/write/masks",
             "the camera is fitted to each run, so that its pictures have a scale of their own",
             "\"center\" and \"height\" of the scene's \"camera\" keep it the same");
}

}  // namespace tumble::sweep
