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

// Below this length of the search direction b2Distance stops, and below this distance it calls shapes with radii
// overlapping: absolute lengths (m).
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

// Its weights of a triangle are products of four coordinates.
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
        return "Products of up to four coordinates of about " + metres(size) + " leave the range of float.";
    if (has_radii(sample.query) && answer == 0.0 && core <= kBox2dEpsilon && sample.exact > 0.0)
        return "With radii, it calls every core distance up to " + metres(kBox2dEpsilon) +
               " an overlap, whatever the size of the shapes.";
    if (std::abs(sample.exact) <= reference::kParityTolerance * resolution)
        return "It computes in world coordinates, which float rounds to " + metres(resolution) +
               " here: the true distance is below what it can see.";
    if (std::min({shortest_edge(sample.query.a), shortest_edge(sample.query.b), std::abs(core)}) < kBox2dEpsilon)
        return "It stops at a search direction shorter than " + metres(kBox2dEpsilon) +
               ", an absolute length that the features of this pair fall below.";
    if (sample.exact < 0.0 && answer > 0.0 && answer <= reference::kParityTolerance * resolution)
        return "It stopped with the origin on an edge of its simplex. The distance it gives is the rounding of its "
               "witness points; only an "
               "exact 0 says overlap.";
    return "Rounding in float lost the sign of a small difference of products.";
}

}  // namespace tumble::tools
