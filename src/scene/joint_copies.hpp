// Repeated joints: which bodies each copy ties, and where.
#pragma once

#include <span>
#include <vector>

#include "scene/joints.hpp"
#include "scene/names.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

// 1 without a repeater.
std::int64_t copy_count(const SceneJoint& joint);

// The copies of bodies that must follow those named, for the last copy of the joint.
std::size_t last_step(const SceneJoint& joint);

// A definition for each copy, in order. The names must be those of bodies, followed by enough copies; `placed` has every
// built body. Throws std::invalid_argument as make_joint() does.
std::vector<JointDef> make_joints(const SceneJoint& joint, const BodyNames& names, std::span<const PlacedBody> placed);

}  // namespace tumble::scene
