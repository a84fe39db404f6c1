// Hatching: slanted lines over the area of a shape, as in technical drawings.
#pragma once

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"
#include "tumble/shape.hpp"

namespace tumble::render {

// Appends lines from the lower left to the upper right. They stay with the world when the view moves, and continue
// from one shape to the next. A shape without area has none.
void add_hatching(Layer& layer, const View& view, const Shape& shape, const Pose& world_from_shape, Color color);

}  // namespace tumble::render
