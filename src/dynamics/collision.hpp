// The stages of a step that find the contacts and their manifolds. Their order is in step.cpp.
//
// Bodies that sleep wake if they are touched, before contacts are solved, and may touch others that sleep. They wake in
// rounds. The contacts of the rounds are sorted into the others once, after the last round.
#pragma once

#include <cstdint>

namespace tumble {

struct Simulation;

// The contacts that end because their boxes are apart: all, or only those that did not touch in this step. A contact
// that touched shows the impulses of the step, and ends in the next one.
enum class EndOf : std::uint8_t { all_contacts, untouched_contacts };

// Sorts woken contacts into the others, ends contacts whose boxes are apart, and begins new ones: only where a box has
// moved. Runs for the caller's changes before the step, and after the motion, so that the step reports each sensor that
// a body entered in it.
void find_pairs(Simulation& simulation, EndOf which);

// Removes the contacts whose boxes are apart, unless `which` keeps them, and those that a change since the last step
// does not allow.
void end_contacts(Simulation& simulation, EndOf which);

// Updates the manifolds of all solid contacts.
void collide_pairs(Simulation& simulation);

// Wakes the sleeping bodies that are touched, collides the contacts that wake or begin with them, and repeats this
// until no sleeping body is touched. Only the first round reads all contacts.
void collide_woken(Simulation& simulation);

}  // namespace tumble
