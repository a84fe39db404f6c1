// Whether the frames of two runs would be the same.
#pragma once

#include <cstdint>

#include "tumble/render.hpp"
#include "tumble/scene.hpp"

namespace tumble::tools {

// xxHash64 of all that the frames of a scene depend on besides the options of the run: the scene without its duration,
// claims, descriptions and custom data; the pixels of its image files; and the camera at the start, which a fit to
// the bodies' motion may have chosen. Throws as is_file_there() and read_picture().
std::uint64_t picture_hash(const Scene& scene, const Camera& start);

}  // namespace tumble::tools
