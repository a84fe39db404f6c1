// Small lines and dots on top of the bodies: which way a shape is turned, where joints hold.
#pragma once

#include <span>

#include "render/primitives.hpp"
#include "render/view.hpp"
#include "tumble/world.hpp"

namespace tumble::render {

// Appends a short line that shows which way the shape is turned, unless the shape is too small in the frame: a radius
// on a circle, else a tick where the shape's edge meets the local x direction from its middle.
void add_orientation_mark(Layer& layer, const View& view, const Shape& shape, const Pose& world_from_shape,
                          Color color);

// Appends the joints that still exist: a dot at each anchor, a line between the two where they are apart.
void add_joints(Layer& layer, const View& view, const World& world, std::span<const JointId> joints);

}  // namespace tumble::render
