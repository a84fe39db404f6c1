// Moves an included scene to its pose in the including one, and prefixes its names.
#pragma once

#include "tumble/scene.hpp"

namespace tumble::scene {

// Moves and rotates the part as `include` states, and puts the prefix before all its names. Removes what applies to a
// whole world: events of gravity, stops, and claims that name neither a body nor a joint. Throws std::invalid_argument
// if positions, velocities, angles or the lengths of names leave the ranges of scene files.
void place_part(Scene& part, const SceneInclude& include);

}  // namespace tumble::scene
