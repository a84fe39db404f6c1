// The pose of every copy of a body when it is created.
#pragma once

#include <cstdint>
#include <vector>

#include "tumble/scene.hpp"

namespace tumble::scene {

// World coordinates; the angle in degrees beside the rotation, because differences of angles stay exact in degrees.
struct PlacedBody {
    Pose pose;
    double angle = 0.0;
};

// All copies, in order. `source` is the number of the body as in SceneInstance::source: it selects the random numbers
// of a scatter repeater. Throws std::invalid_argument as copy_poses() does.
std::vector<PlacedBody> place_copies(const SceneBody& body, std::uint64_t seed, std::size_t source);

}  // namespace tumble::scene
