// From a joint of a scene to the definition for the world, given the poses of its bodies at load.
#pragma once

#include "scene/model/place_copies.hpp"
#include "tumble/joint.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

// Any joint but a gear, without the ids of its bodies. Throws std::invalid_argument for a distance joint or a pulley
// without length.
JointDef make_joint(const SceneJoint& joint, const PlacedBody& a, const PlacedBody& b);

// Without the ids of its joints.
GearJointDef make_gear(const SceneJoint& gear);

}  // namespace tumble::scene
