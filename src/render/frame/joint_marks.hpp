// Joints, drawn discreetly on top of the bodies.
#pragma once

#include <span>

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::render {

// Appends the joints that still exist: a dot at each anchor, a line between the two where they are apart, by way of the
// wheels that a rope runs over.
void add_joints(Layer& layer, const View& view, const World& world, std::span<const SceneJointInstance> joints);

}  // namespace tumble::render
