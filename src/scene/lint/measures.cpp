#include "scene/lint/measures.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::scene {

double mass_ratio(const World& world, BodyId a, BodyId b) {
    const auto [lighter, heavier] = std::minmax({double{world.mass(a).mass}, double{world.mass(b).mass}});
    return heavier / lighter;
}

// The narrowest pair of lines has an edge of the hull on one of them.
double width_of(const Shape& shape) {
    const int count = shape.vertex_count();
    double least = count < 3 ? 0.0 : HUGE_VAL;
    for (int i = 0; i < count && count >= 3; ++i) {
        const DVec2 from(shape.vertex(i)), edge = DVec2(shape.vertex(i + 1 == count ? 0 : i + 1)) - from;
        double height = 0.0;
        for (int k = 0; k < count; ++k) height = std::max(height, cross(edge, DVec2(shape.vertex(k)) - from));
        least = std::min(least, height / length(edge));
    }
    return least + 2.0 * double{shape.radius()};
}

}  // namespace tumble::scene
