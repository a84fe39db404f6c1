// The bodies whose motion continuous collision follows in this step.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// Forgets the swept bodies of the last step.
void clear_swept_bodies(Simulation& simulation);

// The index of a body among the swept ones; kNotSwept if it is not one of them.
std::uint32_t find_swept(const Simulation& simulation, std::uint32_t body);

// The velocity of a body at the time of its sweep's start, or if it is not swept that of the solver.
Twist present_velocity(const Simulation& simulation, std::uint32_t body);

// The index among the swept bodies of a body that may move. Adds it to them if it is not one of them yet, and wakes it
// if it sleeps.
std::uint32_t sweep_body(Simulation& simulation, std::uint32_t body);

// A swept body as a member of a group of impacts that happen at its time.
ImpactBody make_impact_body(const Simulation& simulation, const SweptBody& swept);

// Gives a swept body the box of its motion ahead.
void update_box(Simulation& simulation, std::uint32_t swept);

// A box that covers a shape during its whole sweep, for any rotation.
Aabb box_of_sweep(const Shape& shape, const Sweep& sweep);

// False if a moving body has no sensor, and no static or kinematic shape is in a box that contains those of its
// shapes' sweeps: few bodies need a sweep, which takes two arc tangents. Sensors of the body are in that box, and in
// the layer of kinematic shapes.
bool may_reach_immovable(const Simulation& simulation, std::uint32_t body);

// True if a contact of the body has still to bounce.
bool has_bounce(Simulation& simulation, std::uint32_t swept);

// The motion of a body from the start of the step until a time, a fraction of the step that must not be before that of
// its last impact.
Sweep motion_until(const Simulation& simulation, std::uint32_t body, double time);

// Makes an impact, by its index among all of the step, the last one of its two bodies.
void link_impact(Simulation& simulation, int index);

// Writes the motions that impacts have changed into the solver bodies.
void store_swept_bodies(Simulation& simulation);

}  // namespace tumble
