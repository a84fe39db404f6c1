// Whether two bodies touch, and how far they are apart.
#pragma once

#include "tumble/world.hpp"

namespace tumble::scene {

// Whether shapes of two bodies touched in the last step, also for a part of it, or a sensor of one contains the other.
bool are_touching(const World& world, BodyId a, BodyId b);

// The distance of the nearest shapes of two bodies that can cause contact or sensor events (m); 0 if they overlap,
// infinite if they have none.
double gap_between(const World& world, BodyId a, BodyId b);

}  // namespace tumble::scene
