// Joints of R.U.B.E. exports as joints of a scene.
#pragma once

#include <functional>
#include <optional>

#include "import/rube/rube_values.hpp"

namespace tumble::scene {

// A body that a joint refers to.
struct RubeBody {
    std::string name;
    Pose pose;
};

// Any type of joint but a gear, between bodies found by `body_at` (an index into the export's bodies); nothing, with a
// note or an error, if the scene has no such joint.
std::optional<SceneJoint> read_rube_joint(RubeObject joint, const std::string& type, std::size_t body_count,
                                          const std::function<RubeBody(std::size_t)>& body_at, RubeNotes& notes);

// The gear, on joints found by `joint_at` (an index into the export's joints; they have names, and null is one that the
// scene has not).
std::optional<SceneJoint> read_rube_gear(RubeObject joint, std::size_t joint_count,
                                         const std::function<SceneJoint*(std::size_t)>& joint_at, RubeNotes& notes);

}  // namespace tumble::scene
