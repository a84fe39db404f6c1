// The rules of collision: which pairs of shapes may touch, by their filters, joints, types and rest.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// True if the two shapes may touch: their filters and the joints between their bodies allow it, one of them is dynamic
// and one not at rest for good (asleep, static). A sensor notices all that is not as static as itself.
bool may_collide(const Simulation& simulation, ProxyPair shapes);

// The same without regard to type and rest, for solid shapes alone.
bool may_touch(const Simulation& simulation, ProxyPair shapes);

// True if what was changed since the last step has parted two solid shapes, or keeps them from touching: the next step
// ends their contact.
bool is_over(const Simulation& simulation, const Contact& contact);

}  // namespace tumble
