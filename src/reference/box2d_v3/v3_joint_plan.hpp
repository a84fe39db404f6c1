// Joints as Box2D v3 takes them.
#pragma once

#include <optional>

#include "reference/box2d_v3/library/v3_library.hpp"
#include "tumble/joint.hpp"

namespace tumble::reference {

// Without its bodies. Nothing for a joint that Box2D v3 lacks: a kind other than revolute, prismatic, distance, weld
// and wheel, or one that breaks.
std::optional<box2d_v3::JointPlan> v3_joint_plan(const JointDef& joint);

}  // namespace tumble::reference
