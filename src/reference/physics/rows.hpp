// The table of all rows of the page of evidence.
#pragma once

#include <string_view>
#include <vector>

#include "reference/physics/row.hpp"

namespace tumble::reference {

// All rows in the order of the page.
const std::vector<PhysicsRow>& physics_rows();

// Null if there is no row of that name.
const PhysicsRow* find_physics_row(std::string_view name);

}  // namespace tumble::reference
