// The motion of a body during a step whose poses are not final yet.
#pragma once

#include <cmath>

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

// How far the farthest point of a body moves in the step, m.
inline float displacement_in_step(const SolverBody& body, const BodyMotion& motion) {
    return length(body.delta_position) + std::abs(body.delta_rotation.s) * motion.reach;
}

// How far a point of a body has moved in the step. `anchor` is from the body's origin, when the step began, m.
inline Vec2 shift_in_step(const BodyStore& bodies, std::uint32_t body, Vec2 anchor) {
    const SolverBody& moved = bodies.solver_bodies[bodies.frames[body].solver_body];
    const Vec2 arm = anchor - bodies.frames[body].center_offset;
    return moved.delta_position + rotate(moved.delta_rotation, arm) - arm;
}

}  // namespace tumble
