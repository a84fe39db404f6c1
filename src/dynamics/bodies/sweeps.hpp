// How a body moves in a step whose poses are not final yet, as a sweep.
#pragma once

#include "dynamics/bodies/body_store.hpp"
#include "tumble/cast.hpp"

namespace tumble {

inline Sweep sweep_of(const BodyStore& bodies, std::uint32_t body) {
    const BodyFrame& frame = bodies.frames[body];
    const SolverBody& moved = bodies.solver_bodies[frame.solver_body];
    return {bodies.records[body].mass.center, frame.center, frame.center + DVec2(moved.delta_position),
            angle(frame.pose.rotation), angle(moved.delta_rotation)};
}

}  // namespace tumble
