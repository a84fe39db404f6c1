// Joints of R.U.B.E. exports as joints of a scene.
#pragma once

#include <functional>
#include <optional>

#include "scene/rube_values.hpp"

namespace tumble::scene {

// A body that a joint refers to.
struct RubeBody {
    std::string name;
    Pose pose;
};

// The joint, between bodies found by `body_at` (an index into the export's bodies); nothing, with a note or an error,
// if the scene has no such joint.
std::optional<SceneJoint> read_rube_joint(RubeObject joint, std::size_t body_count,
                                          const std::function<RubeBody(std::size_t)>& body_at, RubeNotes& notes);

}  // namespace tumble::scene
