// The error of a joint.
#pragma once

#include "tumble/world.hpp"

namespace tumble::scene {

// The distance of the anchors for joints that keep them together, their distance perpendicular to the axis for
// prismatic and wheel joints, and the difference to an allowed length for distance joints and pulleys (m). 0 for soft
// joints, gears and filter joints.
double joint_gap(const World& world, JointId id);

}  // namespace tumble::scene
