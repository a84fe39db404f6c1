// Repeaters: the number of copies of a body or joint, and the poses of those of a body.
#pragma once

#include <cstdint>
#include <vector>

#include "tumble/scene.hpp"

namespace tumble::scene {

inline constexpr std::int64_t kMaxBodies = 1000000;  // of a scene, after repeating

struct CopyPose {
    DVec2 position;      // world
    double angle = 0.0;  // degrees
};

// 1 without a repeater.
std::int64_t copy_count(const SceneBody& body);
std::int64_t copy_count(const SceneJoint& joint);

// The poses of all copies, in order. `stream` selects the random numbers of a scatter repeater. Throws
// std::invalid_argument if a scatter repeater finds no room for a copy.
std::vector<CopyPose> copy_poses(const SceneBody& body, std::uint64_t seed, std::uint64_t stream);

}  // namespace tumble::scene
