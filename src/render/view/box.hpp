// Axis-aligned boxes of the world, in double, as a camera sees them.
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
    bool meets(const Box& other) const {
        return lower.x <= other.upper.x && lower.y <= other.upper.y && other.lower.x <= upper.x &&
               other.lower.y <= upper.y;
    }
    bool holds(const Box& other) const {
        return lower.x <= other.lower.x && lower.y <= other.lower.y && other.upper.x <= upper.x &&
               other.upper.y <= upper.y;
    }
};

// Empty for a shape that reaches to infinity.
Box box_of(const Shape& shape, const Pose& pose);

// Of all shapes of a body, as it is now.
Box box_of(const World& world, BodyId body);

Box box_around(std::span<const DVec2> points);

}  // namespace tumble::render
