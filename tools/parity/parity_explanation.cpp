#include "tools/parity/parity_explanation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace tumble::tools {

namespace {

using reference::PairQuery;
using reference::ParityCase;

// b2Distance stops at a search direction shorter than this, and reports an overlap of shapes with radii if their cores
// are closer than this: absolute lengths (m).
constexpr double kBox2dEpsilon = std::numeric_limits<float>::epsilon();

std::string metres(double length) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2g m", length);
    return text.data();
}

double shortest_edge(const Shape& shape) {
    double shortest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const double side =
            length(DVec2(shape.vertex(i)) - DVec2(shape.vertex(i + 1 < shape.vertex_count() ? i + 1 : 0)));
        if (side > 0.0) shortest = std::min(shortest, side);
    }
    return shortest;
}

bool has_radii(const PairQuery& query) { return query.a.radius() > 0.0f || query.b.radius() > 0.0f; }

// The barycentric weights of a triangle in b2Distance are products of four coordinates.
bool leaves_float_range(double size) {
    const double product = size * size * size * size;
    return product > std::numeric_limits<float>::max() || product < std::numeric_limits<float>::min();
}

}  // namespace

std::string why_box2d_failed(const ParityCase& sample) {
    const double resolution = reference::kFloatEpsilon * largest_coordinate(sample.query);
    const double size = error_scale(sample.query);
    const double answer = sample.box2d->distance,
                 core = sample.exact + sample.query.a.radius() + sample.query.b.radius();
    if (!std::isfinite(answer) || leaves_float_range(size))
        return "Products of up to four coordinates of about " + metres(size) + " exceed the range of float.";
    if (has_radii(sample.query) && answer == 0.0 && core <= kBox2dEpsilon && sample.exact > 0.0)
        return "For shapes with radii, b2Distance reports an overlap at every core distance up to " +
               metres(kBox2dEpsilon) + ", independent of the size of the shapes.";
    if (std::abs(sample.exact) <= reference::kParityTolerance * resolution)
        return "b2Distance computes in world coordinates, which float rounds to " + metres(resolution) +
               " here: the exact distance is at most 4 times that.";
    if (std::min({shortest_edge(sample.query.a), shortest_edge(sample.query.b), std::abs(core)}) < kBox2dEpsilon)
        return "b2Distance stops at a search direction shorter than " + metres(kBox2dEpsilon) +
               ", an absolute length, and this pair has smaller features.";
    if (sample.exact < 0.0 && answer > 0.0 && answer <= reference::kParityTolerance * resolution)
        return "b2Distance stopped with the origin on an edge of its simplex. Its distance is the rounding error of "
               "its witness points, and only an exact 0 reports an overlap.";
    return "Rounding in float changed the sign of a small difference of products.";
}

}  // namespace tumble::tools
