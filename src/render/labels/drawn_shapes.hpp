// The shapes of a world in the order in which a frame draws them: static bodies first, then all others; in each of
// these layers the kinds of primitives one after the other (see Layer), and shapes of one kind in the order of bodies.
#pragma once

#include <span>
#include <vector>

#include "render/canvas/primitives.hpp"
#include "render/shapes/joined_parts.hpp"
#include "render/view/view.hpp"
#include "tumble/recording.hpp"

namespace tumble::render {

struct DrawnShape {
    BodyLabel label = 0;
    BodyId body{};
    ShapeId shape{};
    int rank = 0;  // of its layer and kind: a higher one covers a lower one
};

// Collects shapes; keeps its buffers between worlds.
class DrawnShapes {
public:
    void clear() { shapes_.clear(); }

    // Adds the solid shapes in view of a body, whose shapes have the given paints; no paints: all have the same.
    void add(const World& world, const View& view, BodyId body, std::size_t label, std::span<const Paint> paints = {});

    // In the order of drawing.
    std::span<const DrawnShape> sorted();

private:
    std::vector<DrawnShape> shapes_;
    std::vector<Part> parts_;
    std::vector<ShapeId> solid_;
    Layer layer_;  // of one shape, which tells its kind
};

// The width of a line in a frame, in pixels.
double line_width(const View& view);

}  // namespace tumble::render
