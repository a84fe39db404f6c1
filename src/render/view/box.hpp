// Axis-aligned boxes in world coordinates, in double. Cameras are fitted to them.
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "tumble/world.hpp"

namespace tumble::render {

// In world coordinates; empty by default.
struct Box {
    DVec2 lower{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    DVec2 upper{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    bool is_empty() const { return !(lower.x <= upper.x && lower.y <= upper.y); }
    DVec2 center() const { return 0.5 * (lower + upper); }
    DVec2 size() const { return upper - lower; }
    double larger_side() const { return std::max(size().x, size().y); }
    void add(const Box& other) {
        lower = {std::min(lower.x, other.lower.x), std::min(lower.y, other.lower.y)};
        upper = {std::max(upper.x, other.upper.x), std::max(upper.y, other.upper.y)};
    }
    bool overlaps(const Box& other) const {
        return lower.x <= other.upper.x && lower.y <= other.upper.y && other.lower.x <= upper.x &&
               other.lower.y <= upper.y;
    }
    bool contains(const Box& other) const {
        return lower.x <= other.lower.x && lower.y <= other.lower.y && other.upper.x <= upper.x &&
               other.upper.y <= upper.y;
    }
};

// The bounds of a shape; empty if they are not finite.
Box box_of(const Shape& shape, const Pose& pose);

// The bounds of all shapes of a body at its present pose.
Box box_of(const World& world, BodyId body);

// The bounds of a body over all angles about a point of its own (body coordinates).
Box swept_box(const World& world, BodyId body, Vec2 pivot);

// The bounds of points; empty for none.
Box box_around(std::span<const DVec2> points);

}  // namespace tumble::render
