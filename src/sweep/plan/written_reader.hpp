// Reads what each run of a plan writes.
#pragma once

#include "scene/json/diagnostics.hpp"
#include "sweep/plan/plan.hpp"
#include "sweep/plan/plan_object.hpp"

namespace tumble::sweep {

// The member "write" of a plan.
Written read_written(PlanObject& plan, scene::Diagnostics& diagnostics);

}  // namespace tumble::sweep
