#include "shape/convexity.hpp"

#include "shape/orientation.hpp"

namespace tumble {

bool is_convex_outline(std::span<const Vec2> vertices) {
    const std::size_t count = vertices.size();
    for (std::size_t from = 0; from < count; ++from) {
        const std::size_t to = from + 1 < count ? from + 1 : 0;
        for (std::size_t other = 0; other < count; ++other) {
            if (other == from || other == to) continue;
            if (orientation(vertices[from], vertices[to], vertices[other]) < 0) return false;
        }
    }
    return true;
}

}  // namespace tumble
