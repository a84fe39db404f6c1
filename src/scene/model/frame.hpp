// Poses and velocities as seen from a frame. The frame of the world changes no bit of them.
#pragma once

#include "tumble/math.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

inline Pose make_frame(const SceneFrame& frame) { return {frame.position, make_rotation_degrees(frame.angle)}; }

// The rotation that turns `from` into `to`.
inline Rotation rotation_between(Rotation from, Rotation to) {
    return {from.c * to.c + from.s * to.s, from.c * to.s - from.s * to.c};
}

inline Pose seen_from(const Pose& frame, const Pose& pose) {
    return {inverse_transform_point(frame, pose.position), rotation_between(frame.rotation, pose.rotation)};
}

}  // namespace tumble::scene
