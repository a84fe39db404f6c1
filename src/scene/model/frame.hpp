// Poses and velocities as seen from a frame. The frame of the world changes no bit of them.
#pragma once

#include "tumble/math.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

inline Pose make_frame(const SceneFrame& frame) { return {frame.position, make_rotation_degrees(frame.angle)}; }

inline Pose seen_from(const Pose& frame, const Pose& pose) {
    const Rotation f = frame.rotation, q = pose.rotation;
    return {inverse_transform_point(frame, pose.position), {f.c * q.c + f.s * q.s, f.c * q.s - f.s * q.c}};
}

}  // namespace tumble::scene
