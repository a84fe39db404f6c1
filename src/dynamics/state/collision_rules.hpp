// The rules of collision: which pairs of shapes may touch, by filters, joints, body types and sleep.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// True if two solid shapes may touch: their filters and the joints between their bodies allow it.
bool may_touch(const Simulation& simulation, ProxyPair shapes);

// True if a pair needs a contact in this step. Two solid shapes do if they may touch, one of them is dynamic, and one
// is active (awake and dynamic, or a moving kinematic one). A sensor and a solid shape do if their filters allow it and
// not both are static. False if a shape is destroyed or disabled.
bool may_collide(const Simulation& simulation, ProxyPair shapes);

// True if the next step will end a contact of two solid shapes, because their boxes are apart or a change since the
// last step does not allow them to touch. Body types and sleep do not count: a body that falls asleep still touches
// its support.
bool is_over(const Simulation& simulation, const Contact& contact);

}  // namespace tumble
