// Triangles for convex shapes that have too many vertices, or are too large in the frame, for an instance.
//
// The outline is clipped to the frame in double and drawn as a strip that straddles it and a fan inside. Depth varies
// across the strip: the shader blends the edge as it does for instances. No two triangles overlap.
#pragma once

#include <span>
#include <vector>

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"
#include "tumble/shape.hpp"

namespace tumble::render {

// Appends the triangles of the shape's part in view.
void add_outline_mesh(std::vector<MeshVertex>& mesh, const View& view, const Shape& shape, const Pose& world_from_shape,
                      Paint paint);

// Appends the triangles of a convex polygon: points in pixels, counter-clockwise, the outline inside its edge.
void add_convex_mesh(std::vector<MeshVertex>& mesh, std::span<const DVec2> polygon, double outline_width, Paint paint);

// A closed outline in pixels without the points that are closer than half a pixel to the one before. Edges that short
// have no reliable normal, and the mesh would fade at them.
std::vector<DVec2> thinned(const std::vector<DVec2>& outline);

// The shape's outline in pixels, counter-clockwise, arcs as chords at most a twentieth of a pixel off, points closer
// than half a pixel left out.
std::vector<DVec2> pixel_outline(const View& view, const Shape& shape, const Pose& world_from_shape);

}  // namespace tumble::render
