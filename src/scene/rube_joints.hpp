// Joints of R.U.B.E. exports as joints of a scene.
#pragma once

#include <functional>
#include <optional>

#include "scene/rube_values.hpp"

namespace tumble::scene {

// The joint, between bodies named by `name_of` (an index into the export's bodies); nothing, with a note or an error,
// if the scene has no such joint.
std::optional<SceneJoint> read_rube_joint(RubeObject joint, std::size_t body_count,
                                          const std::function<std::string(std::size_t)>& name_of, RubeNotes& notes);

}  // namespace tumble::scene
