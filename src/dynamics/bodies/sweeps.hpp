// The motion of a body during a step whose poses are not final yet.
#pragma once

#include "debug/check.hpp"
#include "dynamics/bodies/body_store.hpp"
#include "tumble/cast.hpp"

namespace tumble {

// The sweep of a body's centre of mass and angle; a body without a solver body rests.
inline Sweep sweep_of(const BodyStore& bodies, std::uint32_t body) {
    const BodyFrame& frame = bodies.frames[body];
    TUMBLE_CHECK(frame.solver_body < bodies.solver_bodies.size());
    const SolverBody& moved = bodies.solver_bodies[frame.solver_body];
    return {bodies.records[body].mass.center, frame.center, frame.center + DVec2(moved.delta_position),
            angle(frame.pose.rotation), angle(moved.delta_rotation)};
}

// The same for a motion that may still be stopped.
inline Sweep sweep_of(const BodyStore& bodies, std::uint32_t body, const FreeMotion& motion) {
    const BodyFrame& frame = bodies.frames[body];
    return {bodies.records[body].mass.center, frame.center, frame.center + DVec2(motion.path),
            angle(frame.pose.rotation), static_cast<double>(motion.turn)};
}

}  // namespace tumble
