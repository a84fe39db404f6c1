// Warnings about valid plans: what is probably not meant, or costs more than it seems.
#pragma once

#include "scene/json/diagnostics.hpp"
#include "sweep/plan/plan.hpp"
#include "sweep/plan/plan_trial.hpp"

namespace tumble::sweep {

void add_plan_lints(const Plan& plan, const std::vector<SceneFacts>& scenes, scene::Diagnostics& diagnostics);

}  // namespace tumble::sweep
