// Tries a plan on its scenes before anything is simulated.
#pragma once

#include <string>

#include "scene/json/diagnostics.hpp"
#include "sweep/plan/plan.hpp"

namespace tumble::sweep {

// Reads each scene as its first run does, and its expressions. An error in a value of the plan is reported at the
// parameter that sets it. Returns the canonical texts of the scenes. Throws FileError, and SceneError for a scene that
// is not valid by itself.
std::string try_first_runs(const Plan& plan, scene::Diagnostics& diagnostics);

// The JSON pointer of the path of a scene in its plan.
std::string pointer_of_scene(const Plan& plan, std::size_t scene);

}  // namespace tumble::sweep
