// Images of R.U.B.E. exports.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "import/rube/rube_values.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

struct RubeImage {
    std::optional<std::size_t> body;  // index in the export; nothing: the world
    SceneImage image;                 // in coordinates of the body
};

// The images of the export. Their order is that of their `renderOrder`; those of the world, which are backgrounds, are
// behind all bodies.
std::vector<RubeImage> read_rube_images(std::vector<RubeObject> list, std::size_t body_count, RubeNotes& notes);

}  // namespace tumble::scene
