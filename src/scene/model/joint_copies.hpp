// Repeated joints: which bodies each copy joins, and where.
#pragma once

#include <span>
#include <vector>

#include "scene/model/joints.hpp"
#include "scene/model/names.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

// A definition whose ids are not known before its bodies, or the joints of a gear, are created.
struct JointCopy {
    JointDef def;
    std::size_t a = 0, b = 0;  // indices in SceneWorld::bodies; of a gear, in SceneWorld::joints
};

// By how many copies the bodies of the last copy, or the joints of a gear's last copy, follow those that the joint
// names.
std::size_t last_step(const SceneJoint& joint);

// A definition for each copy of any joint but a gear, in order. The bodies that the joint names must exist, and at
// least last_step() copies must follow each that is a copy. placed[built bodies]. Throws std::invalid_argument as
// make_joint() does.
std::vector<JointCopy> make_joints(const SceneJoint& joint, const BodyNames& names, std::span<const PlacedBody> placed);

// The same for a gear and the joints that it names.
std::vector<JointCopy> make_gears(const SceneJoint& gear, const JointNames& names);

}  // namespace tumble::scene
