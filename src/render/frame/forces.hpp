// The forces of contacts as arrows.
#pragma once

#include "render/frame/marks.hpp"
#include "render/view/view.hpp"
#include "tumble/world.hpp"

namespace tumble::render {

inline constexpr double kForceLength = 16.0;  // pixels at 720 rows, of an arrow of force_unit()

// A round number near the mean weight of the dynamic bodies, at least 1e-9 N: it changes only if their mass does.
double force_unit(const World& world);

// An arrow at each contact point for each of its bodies that is not static: the force on it, the impulse of the last
// step over its duration. Its length grows with the force, up to five times kForceLength.
void add_forces(Marks& marks, const View& view, const World& world, Color color);

}  // namespace tumble::render
