// Convex parts of a body that share whole edges, drawn as one shape: no line between the parts, and an outline along
// the edges that are not shared.
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

// Sets `is_joined` of each part that is joined: a polygon without a radius that has an edge with the same ends, bit for
// bit, as another part in the same paint.
void find_joined(std::span<Part> parts);

// Appends the parts that are joined.
void add_joined_parts(Layer& layer, const View& view, std::span<const Part> parts, const Pose& world_from_body);

}  // namespace tumble::render
