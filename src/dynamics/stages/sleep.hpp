// Falling asleep and waking: islands leave the hot arrays as a whole and come back as a whole.
//
// An island is a set of dynamic bodies tied together by touching contacts and joints. It falls asleep when each of its
// bodies has been slow for half a second (Tuning::time_to_sleep); it wakes when one of its bodies is touched by
// something awake, or when a caller changes what it rests on.
#pragma once

#include <cstdint>

#include "dynamics/state/simulation.hpp"

namespace tumble {

// A stage of the step: counts for how long bodies have been slow, and puts islands to sleep.
void fall_asleep(Simulation& simulation);

// A stage of the step: wakes the sleeping bodies that something awake touches. False if there are none; otherwise there
// are new pairs to find and to collide.
bool wake_touched(Simulation& simulation);

// Puts the island of an awake dynamic body to sleep, however fast it moves.
void put_island_to_sleep(Simulation& simulation, std::uint32_t body);

// Puts a dynamic body to sleep that touches nothing and has no joint yet.
void put_new_body_to_sleep(Simulation& simulation, std::uint32_t body);

// True if two bodies touch of which at least one sleeps.
bool touch_in_sleep(const Simulation& simulation, std::uint32_t body_a, std::uint32_t body_b);

// Two sleeping bodies are joined: their islands become one.
void merge_sleeping_islands(Simulation& simulation, std::uint32_t body_a, std::uint32_t body_b);

// Wakes the island of a body, and starts its rest anew if it is awake.
void wake(Simulation& simulation, std::uint32_t body);

// Wakes a joint, unless one of its bodies sleeps or is disabled.
void wake_joint(Simulation& simulation, JointId id);

// Wakes a body, or what leans on it or is tied to it if it is not dynamic, before the body is changed or goes.
void wake_with_neighbors(Simulation& simulation, std::uint32_t body);

// Wakes what sleeps where a body is now, by the boxes of their shapes.
void wake_met(Simulation& simulation, std::uint32_t body);

}  // namespace tumble
