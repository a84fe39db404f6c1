// A short run of a scene that records where its bodies move. The camera is fitted to the result.
#pragma once

#include <cstddef>
#include <vector>

#include "render/view/box.hpp"
#include "tumble/scene.hpp"

namespace tumble::render {

// The bounds of a body at its first pose, and those of all its poses during the preview.
struct MotionBounds {
    Box start;
    Box whole;
    std::size_t body = 0;  // index into SceneWorld::bodies
};

// The bounds of every body that is not static, including those that the timeline spawns. The preview runs to the end of
// the scene, or until a fixed budget of steps times bodies is spent: a count and no clock, so that every frame and
// machine gets the same result. It ends early at a state that is not finite. A scene of more than 2500 bodies is not
// run, and the result is empty.
std::vector<MotionBounds> preview_motion(const Scene& scene);

}  // namespace tumble::render
