// Contacts as a user sees them: ids, world points and impulses.
#pragma once

#include <vector>

#include "dynamics/state/simulation.hpp"
#include "tumble/world.hpp"

namespace tumble {

// The contact points of the last step in order of shape ids, without those of shapes destroyed since;
// those of sleeping bodies too. Of one body, or with kNoBody of all.
std::vector<ContactPoint> report_contacts(const Simulation& simulation, std::uint32_t body);

// The pairs behind them, with and without points.
std::vector<ShapePair> report_pairs(const Simulation& simulation);

}  // namespace tumble
