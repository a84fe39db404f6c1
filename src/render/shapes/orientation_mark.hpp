// A small line on a body that shows which way it is turned.
#pragma once

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"
#include "tumble/shape.hpp"

namespace tumble::render {

// Appends a radius on a circle, else a tick where the shape's edge meets the local x direction from its middle; nothing
// if the shape is too small in the frame.
void add_orientation_mark(Layer& layer, const View& view, const Shape& shape, const Pose& world_from_shape,
                          Color color);

}  // namespace tumble::render
