// Joints of Box2D v3.
#pragma once

#include <box2d/box2d.h>

#include "reference/box2d_v3/library/v3_library.hpp"

namespace tumble::box2d_v3 {

void create_joint(b2WorldId world, b2BodyId a, b2BodyId b, const JointPlan& plan);

}  // namespace tumble::box2d_v3
