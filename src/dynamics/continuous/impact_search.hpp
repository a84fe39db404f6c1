// Which impacts are ahead: for each swept body the first one.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// Sweeps the bodies that move far in this step and leave their free motion, and those of contacts that bounce. Collects
// the sensors near the path of a body that moves far.
void find_fast_bodies(Simulation& simulation);

// Finds the first impact ahead of a swept body, and puts it into the queue. Collects the sensors near its path.
void find_next_impact(Simulation& simulation, std::uint32_t swept);

// The body has none until it is searched for again.
void forget_next_impact(Simulation& simulation, std::uint32_t swept);

// Notes if impacts have taken a body off the course on which the solver kept it apart from others.
void note_course(Simulation& simulation, std::uint32_t swept);

// True if a body moves by more than half of its extent until the step ends.
bool moves_far(const Simulation& simulation, std::uint32_t swept);

}  // namespace tumble
