// Motion of the bodies within a sub-step: semi-implicit Euler.
#pragma once

#include <span>

#include "dynamics/bodies/body_store.hpp"
#include "dynamics/bodies/speed_limits.hpp"
#include "tasks/crew.hpp"
#include "tumble/math.hpp"

namespace tumble {

struct BodyVelocity {
    Vec2 linear;           // m/s
    float angular = 0.0f;  // rad/s

    BodyVelocity& operator+=(const BodyVelocity& other) {
        linear += other.linear;
        angular += other.angular;
        return *this;
    }
    BodyVelocity& operator-=(const BodyVelocity& other) {
        linear -= other.linear;
        angular -= other.angular;
        return *this;
    }
};

inline BodyVelocity velocity_of(const SolverBody& body) { return {body.velocity, body.angular_velocity}; }

// Dynamic bodies: v += h (g + F / m), then the damping v / (1 + h c) and the speed limits, so that constraints
// propagate no more speed than a body may have. Other bodies keep their velocities. `h` is the sub-step, s.
//
// `without_contacts`, by solver body, gets the velocities after that. If `warm_starts`, it has those that the bodies
// would have now if contacts had not acted in the last sub-step; the bodies are then given again what contacts did.
// That is the warm start of all contacts, as their arms stay the same within a step, without a pass over the contacts.
void integrate_velocities(BodyStore& bodies, Vec2 gravity, float h, const SpeedLimits& limits,
                          std::span<BodyVelocity> without_contacts, bool warm_starts, Crew& crew);

// Advances the deltas of position and rotation by the velocities. The speed limits apply before: at the speeds that
// contradictory joints may give in a sub-step, the bodies would end farther apart than they were. What the limits
// change is changed in `without_contacts` too.
void integrate_positions(BodyStore& bodies, float h, const SpeedLimits& limits,
                         std::span<BodyVelocity> without_contacts, Crew& crew);

}  // namespace tumble
