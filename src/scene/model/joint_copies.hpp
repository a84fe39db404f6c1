// Repeated joints: which bodies each copy ties, and where.
#pragma once

#include <span>
#include <vector>

#include "scene/model/joints.hpp"
#include "scene/model/names.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

// 1 without a repeater.
std::int64_t copy_count(const SceneJoint& joint);

// The copies of bodies, or of a gear's joints, that must follow those named, for the last copy of the joint.
std::size_t last_step(const SceneJoint& joint);

// A definition for each copy of any joint but a gear, in order. The names must be those of bodies, followed by enough
// copies; `placed` has every built body. Throws std::invalid_argument as make_joint() does.
std::vector<JointDef> make_joints(const SceneJoint& joint, const BodyNames& names, std::span<const PlacedBody> placed);

// The same of a gear. `built` has the copies of every other joint of the scene, by its index.
std::vector<JointDef> make_gears(const SceneJoint& gear, const JointNames& names,
                                 const std::vector<std::vector<JointId>>& built);

}  // namespace tumble::scene
