// Contacts as the API reports them: with ids, world points and impulses.
#pragma once

#include <vector>

#include "dynamics/state/simulation.hpp"
#include "tumble/world.hpp"

namespace tumble {

// The contact points of the last step in order of shape ids, those of sleeping bodies too, those of shapes destroyed
// since not: of the body with this index, or with kNoBody of all bodies.
std::vector<ContactPoint> report_contacts(const Simulation& simulation, std::uint32_t body);

// The pairs of live shapes that the last step collided, with or without contact points, in order of shape ids.
std::vector<ShapePair> report_pairs(const Simulation& simulation);

}  // namespace tumble
