// Where every body of a scene stands when it is made, copies included.
#pragma once

#include <vector>

#include "scene/model/joints.hpp"

namespace tumble::scene {

// The copies of a body, whose number as in SceneInstance::source draws its own random places; ids are not set. Throws
// std::invalid_argument as copy_places() does.
std::vector<PlacedBody> place_copies(const SceneBody& body, std::uint64_t seed, std::size_t source);

}  // namespace tumble::scene
