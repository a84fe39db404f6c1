// Mass data of R.U.B.E. exports.
#pragma once

#include <vector>

#include "import/rube/rube_values.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

// The mass of a body as Box2D interprets the export: a mass of 0 counts as 1 kg; the inertia, which the file states
// about the body's origin, counts only if it is positive and the rotation is not fixed.
SceneMass read_rube_mass(RubeObject& body, bool fixed_rotation);

// True if the shapes of the body, with the densities of their materials, have this mass within rounding.
bool is_mass_of_shapes(const SceneMass& mass, const SceneBody& body, const std::vector<SceneMaterial>& materials);

}  // namespace tumble::scene
