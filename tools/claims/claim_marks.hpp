// What the picture of a failed claim marks.
#pragma once

#include "tumble/render.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

// Marks the region of the claim, the bodies that it names or that violate it in the world of the deciding step, and
// shows what was expected and found.
Marking marks_of(const SceneExpectation& expected, const ExpectationResult& result, const SceneWorld& built);

}  // namespace tumble::tools
