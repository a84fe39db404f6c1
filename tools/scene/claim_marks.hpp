// What a picture of a claim points at.
#pragma once

#include "tumble/render.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

// The region of the claim, the bodies that it names or that were in its way in the world of the deciding step, and what
// was expected and found.
Marking marks_of(const SceneExpectation& expected, const ExpectationResult& result, const SceneWorld& built);

}  // namespace tumble::tools
