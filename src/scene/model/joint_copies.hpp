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

// How many copies of its bodies, or of a gear's joints, must follow those that the joint names: those of its last copy.
std::size_t last_step(const SceneJoint& joint);

// A definition for each copy of any joint but a gear, in order. The names must be those of bodies that enough copies
// follow. placed[built bodies]. Throws std::invalid_argument as make_joint() does.
std::vector<JointCopy> make_joints(const SceneJoint& joint, const BodyNames& names, std::span<const PlacedBody> placed);

// The same for a gear and the joints that it names.
std::vector<JointCopy> make_gears(const SceneJoint& gear, const JointNames& names);

}  // namespace tumble::scene
