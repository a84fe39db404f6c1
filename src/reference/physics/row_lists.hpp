// The rows of each subject, concatenated by physics_rows().
#pragma once

#include <vector>

#include "reference/physics/row.hpp"

namespace tumble::reference {

std::vector<PhysicsRow> friction_rows();
std::vector<PhysicsRow> impact_rows();
std::vector<PhysicsRow> continuous_rows();
std::vector<PhysicsRow> joint_rows();
std::vector<PhysicsRow> ragdoll_rows();
std::vector<PhysicsRow> pile_rows();
std::vector<PhysicsRow> flight_rows();

}  // namespace tumble::reference
