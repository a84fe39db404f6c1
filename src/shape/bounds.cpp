// Boxes and sizes of shapes.
#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
#include "tumble/shape.hpp"

namespace tumble {

namespace {

// At least the rounding of a double to float, and at most two steps between floats: 2^-23 |v|, and 2^-149 near zero.
double outward_step(double value) { return 0x1p-23 * std::abs(value) + 0x1p-149; }

constexpr double kLargestFloat = std::numeric_limits<float>::max();

float round_down(double value) { return static_cast<float>(std::min(value - outward_step(value), kLargestFloat)); }
float round_up(double value) { return static_cast<float>(std::max(value + outward_step(value), -kLargestFloat)); }

struct Interval {
    double lower;
    double upper;
};

// min and max over the vertices of p x + q y, shifted and grown. Products of two floats are exact in double, so that
// only their sum and the shift round: less than 2^-51 of the largest term.
Interval extent_along(const Shape& shape, double p, double q, double shift) {
    const float* x = shape.x().data();
    const float* y = shape.y().data();
    double lower = p * x[0] + q * y[0], upper = lower;
    for (int i = 1; i < shape.vertex_count(); ++i) {
        const double along = p * x[i] + q * y[i];
        lower = std::min(lower, along);
        upper = std::max(upper, along);
    }
    const double radius = shape.radius();
    const double rounding = 0x1p-51 * (std::max(std::abs(lower), std::abs(upper)) + std::abs(shift) + radius);
    return {lower + shift - radius - rounding, upper + shift + radius + rounding};
}

}  // namespace

Aabb bounds(const Shape& shape, const Pose& world_from_shape) {
    const Rotation q = world_from_shape.rotation;
    const DVec2 position = world_from_shape.position;
    if (shape.vertex_count() == 0 || !std::isfinite(shape.core_radius() + shape.radius()) ||
        !is_finite(Vec2{q.c, q.s}) || !is_finite(position))
        return {};
    const Interval along_x = extent_along(shape, q.c, -q.s, position.x);
    const Interval along_y = extent_along(shape, q.s, q.c, position.y);
    TUMBLE_CHECK(along_x.lower <= along_x.upper);
    TUMBLE_CHECK(along_y.lower <= along_y.upper);
    return {{round_down(along_x.lower), round_down(along_y.lower)}, {round_up(along_x.upper), round_up(along_y.upper)}};
}

Extent extent(const Shape& shape) {
    if (shape.vertex_count() == 0) return {};
    const auto [x_min, x_max] = std::ranges::minmax(shape.x());
    const auto [y_min, y_max] = std::ranges::minmax(shape.y());
    const double grown = 2.0 * shape.radius();
    const double width = static_cast<double>(x_max) - x_min + grown,
                 height = static_cast<double>(y_max) - y_min + grown;
    TUMBLE_CHECK(!(width < 0.0));
    return {static_cast<float>(std::max(width, height)), static_cast<float>(std::min(width, height))};
}

float farthest_distance(const Shape& shape, Vec2 from) {
    double farthest = 0.0;
    for (int i = 0; i < shape.vertex_count(); ++i)
        farthest = std::max(farthest, length(DVec2(shape.vertex(i)) - DVec2(from)));
    return round_up(farthest + shape.radius());
}

}  // namespace tumble
