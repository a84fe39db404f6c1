// Mass data of R.U.B.E. exports.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "import/rube/rube_values.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

// The mass of a dynamic body as Box2D interprets the export: a mass of 0 counts as 1 kg; the inertia, which the file
// states about the body's origin, counts only if it is positive and the rotation is not fixed. Empty if the shapes of
// the body, with the densities of their materials, have this mass within rounding.
//
// An inertia that is less than the mass times the squared distance of its centre from the origin belongs to no body.
// That of the shapes, scaled to the mass, replaces it, with a warning that names the body by `owner`.
std::optional<SceneMass> read_rube_mass(RubeObject& json, const SceneBody& body, const std::string& owner,
                                        const std::vector<SceneMaterial>& materials);

}  // namespace tumble::scene
