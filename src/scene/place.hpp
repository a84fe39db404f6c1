// Where every body of a scene stands at load, copies included.
#pragma once

#include <string>
#include <vector>

#include "scene/joints.hpp"

namespace tumble::scene {

// The copies of one entry of Scene::bodies; ids are not set. Throws std::invalid_argument as copy_places() does.
std::vector<PlacedBody> place_copies(const Scene& scene, std::size_t source);

}  // namespace tumble::scene
