// Convex parts of a body that share whole edges, drawn as the one shape that they make: filled without a line between
// them, and outlined along the edges that no two of them share.
#pragma once

#include <span>
#include <vector>

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"
#include "tumble/shape.hpp"

namespace tumble::render {

// A shape of a body, and how it is painted.
struct Part {
    const Shape* shape = nullptr;
    Paint paint;
    bool is_joined = false;  // shares an edge with another part in the same paint
};

// Finds the parts that are joined: polygons without rounding, with edges that lie on another's to the bit.
void find_joined(std::span<Part> parts);

// Appends the parts that are joined.
void add_joined_parts(Layer& layer, const View& view, std::span<const Part> parts, const Pose& world_from_body);

}  // namespace tumble::render
