// A pose for each copy: the one place where a scene's degrees become a rotation. Adding 0 turns -0, which no file can
// hold, into 0.
#include "scene/model/place.hpp"

#include "scene/model/repeat.hpp"

namespace tumble::scene {

std::vector<PlacedBody> place_copies(const SceneBody& body, std::uint64_t seed, std::size_t source) {
    std::vector<PlacedBody> placed;
    for (const CopyPlace& place : copy_places(body, seed, source))
        placed.push_back({{}, {place.position + DVec2{}, make_rotation_degrees(place.angle + 0.0)}, place.angle});
    return placed;
}

}  // namespace tumble::scene
