// The only conversion of a body's angle from degrees to a rotation. Adding 0 turns -0, which JSON text does not keep,
// into 0.
#include "scene/model/place_copies.hpp"

#include "scene/model/repeat.hpp"

namespace tumble::scene {

std::vector<PlacedBody> place_copies(const SceneBody& body, std::uint64_t seed, std::size_t source) {
    std::vector<PlacedBody> placed;
    for (const CopyPose& copy : copy_poses(body, seed, source))
        placed.push_back({{copy.position + DVec2{}, make_rotation_degrees(copy.angle + 0.0)}, copy.angle});
    return placed;
}

}  // namespace tumble::scene
