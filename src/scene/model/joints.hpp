// From a scene's joint to the world's, given where its bodies are at load.
#pragma once

#include "tumble/joint.hpp"
#include "tumble/scene.hpp"
#include "tumble/world.hpp"

namespace tumble::scene {

// A body at load; the angle in degrees beside its rotation, because differences of angles stay exact in degrees.
struct PlacedBody {
    BodyId id;
    Pose pose;
    double angle = 0.0;
};

// Any joint but a gear. Throws std::invalid_argument for a distance joint or a pulley without length.
JointDef make_joint(const SceneJoint& joint, const PlacedBody& a, const PlacedBody& b);

GearJointDef make_gear(const SceneJoint& joint, JointId a, JointId b);

}  // namespace tumble::scene
