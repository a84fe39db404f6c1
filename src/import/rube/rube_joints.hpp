// Reads joints of R.U.B.E. exports.
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

// Reads a joint of any type but gear. `body_at` returns the body at an index of the export's list. Empty, with a note
// or an error, if a scene cannot have such a joint.
std::optional<SceneJoint> read_rube_joint(RubeObject joint, const std::string& type, std::size_t body_count,
                                          const std::function<RubeBody(std::size_t)>& body_at, RubeNotes& notes);

// Reads a gear. `joint_at` returns the joint at an index of the export's list, with a name, or null if it was left out.
// Empty, with a note or an error, if a scene cannot have such a gear.
std::optional<SceneJoint> read_rube_gear(RubeObject joint, std::size_t joint_count,
                                         const std::function<SceneJoint*(std::size_t)>& joint_at, RubeNotes& notes);

}  // namespace tumble::scene
