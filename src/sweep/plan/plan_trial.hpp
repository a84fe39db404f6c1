// Tries a plan on its scenes before anything is simulated.
#pragma once

#include <string>
#include <vector>

#include "scene/json/diagnostics.hpp"
#include "sweep/plan/plan.hpp"

namespace tumble::sweep {

// What the warnings about a plan ask of a scene, as its first run has it.
struct SceneFacts {
    bool has_claims = false;
    bool has_camera = false;  // that the scene states, so that it is the same for all runs
};

struct TriedScenes {
    std::string texts{};  // canonical
    std::vector<SceneFacts> facts{};
};

// Reads each scene as its first run does, and its expressions. An error in a value of the plan is reported at the
// parameter that sets it. Throws FileError, and SceneError for a scene that is not valid by itself.
TriedScenes try_first_runs(const Plan& plan, scene::Diagnostics& diagnostics);

// The JSON pointer of the path of a scene in its plan.
std::string pointer_of_scene(const Plan& plan, std::size_t scene);

}  // namespace tumble::sweep
