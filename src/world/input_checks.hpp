// Checks of the arguments of public calls: each throws std::invalid_argument that names the argument, prints its value
// and states what was expected.
#pragma once

#include <optional>
#include <string>

#include "tumble/body.hpp"
#include "tumble/joint.hpp"
#include "tumble/world.hpp"

namespace tumble {

void check(const WorldDef& def);
void check(const Threads& threads);
void check(const BodyDef& def);
void check(const ShapeDef& def);
void check(const Shape& shape);
void check(const SurfaceMaterial& material);
void check(const std::optional<BodyMass>& mass);
void check_pose(const Pose& pose, const std::string& owner);
void check(const JointDef& def);  // its numbers alone; World checks the ids
void check_velocity(Vec2 velocity, float angular_velocity);
void check_action(Vec2 action, const char* what);   // a force or an impulse
void check_action(float action, const char* what);  // a torque or an angular impulse
void check_point(DVec2 point);

}  // namespace tumble
