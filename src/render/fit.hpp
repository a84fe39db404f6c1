// What a camera should have in view when the scene does not say.
#pragma once

#include <algorithm>
#include <limits>

#include "tumble/world.hpp"

namespace tumble::render {

// An axis-aligned box in world coordinates; empty by default.
struct Box {
    DVec2 lower{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    DVec2 upper{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    bool is_empty() const { return !(lower.x <= upper.x && lower.y <= upper.y); }
    DVec2 center() const { return 0.5 * (lower + upper); }
    DVec2 size() const { return upper - lower; }
    void add(const Box& other) {
        lower = {std::min(lower.x, other.lower.x), std::min(lower.y, other.lower.y)};
        upper = {std::max(upper.x, other.upper.x), std::max(upper.y, other.upper.y)};
    }
};

// The box of all that moves, grown by the way down to the ground. What never moves is included whole if that takes
// little more room, else as far as it is near. Empty if the world is.
Box interesting_box(const World& world, double aspect_ratio);

// The height of a frame that holds a box of that size.
inline double height_for(DVec2 size, double aspect_ratio) { return std::max(size.y, size.x / aspect_ratio); }

}  // namespace tumble::render
