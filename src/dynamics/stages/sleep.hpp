// Falling asleep and waking: an island leaves the arrays of moving bodies as a whole, and returns as a whole.
//
// An island is a set of dynamic bodies connected by touching contacts and joints. It falls asleep when each of its
// bodies has been slow for half a second (Tuning::time_to_sleep). An island that touches and is joined to no body at
// rest must not drift either: nothing stops what moves through free space without damping. It wakes when an awake body
// touches one of its bodies, or when the user changes a body that it rests on.
//
// After a search that finds no island at rest, the next three steps do not search. An island may therefore fall asleep
// up to three steps later than its bodies allow, also if the search was in vain because of other islands.
#pragma once

#include <cstdint>

#include "dynamics/state/simulation.hpp"

namespace tumble {

// A stage of the step: measures how long bodies have been slow, and puts islands to sleep.
void fall_asleep(Simulation& simulation);

// Puts the island of an awake dynamic body to sleep, however fast it moves.
void put_island_to_sleep(Simulation& simulation, std::uint32_t body);

// Puts a dynamic body without contacts and joints to sleep.
void put_new_body_to_sleep(Simulation& simulation, std::uint32_t body);

// True if two bodies touch, at least one of which sleeps.
bool touch_in_sleep(const Simulation& simulation, std::uint32_t body_a, std::uint32_t body_b);

// Merges the islands of two sleeping bodies, which a joint connects.
void merge_sleeping_islands(Simulation& simulation, std::uint32_t body_a, std::uint32_t body_b);

// Wakes the island of a body. A body that is awake starts to count its still time again.
void wake(Simulation& simulation, std::uint32_t body);

// Wakes a joint, unless one of its bodies sleeps or is disabled.
void wake_joint(Simulation& simulation, JointId id);

// Call before a body is changed or destroyed: wakes a dynamic body, or the bodies that touch a static or kinematic one
// or are joined to it.
void wake_with_neighbors(Simulation& simulation, std::uint32_t body);

// Wakes the sleeping bodies whose boxes overlap those of a body.
void wake_overlapping(Simulation& simulation, std::uint32_t body);

}  // namespace tumble
