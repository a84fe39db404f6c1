#include "scene/lint/measures.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::scene {

namespace {

constexpr double kOverlap = 0.02;       // of the smaller extent: twice the overlap of resting contacts
constexpr double kOverlapLimit = 0.01;  // m, in a world of scale 1: the upper bound of the above

}  // namespace

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

double smallest_extent(const World& world, BodyId body) {
    double least = HUGE_VAL;
    for (const ShapeId shape : world.shapes(body)) {
        const Extent size = extent(world.shape(shape));
        least = std::min(least, double{size.smaller > 0.0f ? size.smaller : size.larger});
    }
    return least;
}

double largest_extent(const World& world, BodyId body) {
    double size = 0.0;
    for (const ShapeId shape : world.shapes(body)) size = std::max(size, double{extent(world.shape(shape)).larger});
    return size;
}

double smaller_size(double size_a, double size_b) {
    return size_a > 0.0 && size_b > 0.0 ? std::min(size_a, size_b) : std::max(size_a, size_b);
}

double allowed_overlap(double smallest_extent, double scale) {
    return std::min(kOverlap * smallest_extent, scale * kOverlapLimit);
}

}  // namespace tumble::scene
