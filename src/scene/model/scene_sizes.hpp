// How many entries the lists of a scene have.
#pragma once

#include <cstddef>

#include "tumble/scene.hpp"

namespace tumble::scene {

struct SceneSizes {
    std::size_t materials = 0, bodies = 0, joints = 0, timeline = 0, expect = 0;
};

inline SceneSizes sizes_of(const Scene& scene) {
    return {scene.materials.size(), scene.bodies.size(), scene.joints.size(), scene.timeline.size(),
            scene.expect.size()};
}

}  // namespace tumble::scene
