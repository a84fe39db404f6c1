// Sensors, drawn as areas that do not look solid.
#pragma once

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"
#include "tumble/shape.hpp"

namespace tumble::render {

// Appends the shape as a faint area with a dashed edge.
void add_sensor_area(Layer& layer, const View& view, const Shape& shape, const Pose& world_from_shape, Paint paint);

}  // namespace tumble::render
