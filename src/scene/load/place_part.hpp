// An included scene on its way into another: in its place, under its names.
#pragma once

#include "tumble/scene.hpp"

namespace tumble::scene {

// Moves and turns the part as `include` says, puts the prefix before all its names, and takes away what belongs to the
// world of its own: gravity, and the claims that name neither a body nor a joint. Throws std::invalid_argument for what
// no scene file can say: places, velocities or angles out of range, names too long.
void place_part(Scene& part, const SceneInclude& include);

}  // namespace tumble::scene
