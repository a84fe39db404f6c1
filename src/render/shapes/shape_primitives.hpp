// Shapes as primitives: an instance of a circle, box or polygon if the shape is one, else a mesh.
#pragma once

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"
#include "tumble/shape.hpp"

namespace tumble::render {

// Appends the shape unless it is out of view. `line_width` (pixels) is the width of a segment, which has no area.
void add_shape(Layer& layer, const View& view, const Shape& shape, const Pose& world_from_shape, Paint paint,
               double line_width);

// A line between two points in pixels, with round ends.
BoxInstance make_line(DVec2 from, DVec2 to, double width, Color color);

// Appends the part of a line in view; points and width in pixels, the ends round.
void add_line(Layer& layer, const View& view, DVec2 from, DVec2 to, double width, Color color);

// The rectangle of least area around a polygon's core that has a side along one of its edges; local coordinates.
struct TightBox {
    Vec2 center;
    Vec2 axis{1.0f, 0.0f};  // unit
    Vec2 half;
    bool is_exact = false;  // the core is this rectangle
};

// For shapes of 3 to Shape::kInlineVertices vertices.
TightBox tight_box(const Shape& shape);

}  // namespace tumble::render
