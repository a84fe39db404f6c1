// A small line on a body that shows its angle.
#pragma once

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"
#include "tumble/shape.hpp"

namespace tumble::render {

// Appends a radius to a circle, and to other shapes a tick at the edge in the local x direction from the middle.
// Nothing if the shape is too small in the frame.
void add_orientation_mark(Layer& layer, const View& view, const Shape& shape, const Pose& world_from_shape,
                          Color color);

}  // namespace tumble::render
