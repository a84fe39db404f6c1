#include "dynamics/impacts/point_impulse.hpp"

#include <cmath>

#include "debug/check.hpp"

namespace tumble {

namespace {

// A determinant below this part of normal * tangent is rounding: normal and tangential impulses move the bodies alike.
constexpr double kSingularDeterminant = 1e-9;

}  // namespace

double find_point_impulse(const PointResponse& response, double normal_speed, double tangent_speed, double friction) {
    const double a = response.normal, b = response.tangent, c = response.coupling;
    TUMBLE_CHECK(a > 0.0);
    if (normal_speed >= 0.0) return 0.0;

    // The sliding goes on in its direction. A point at rest begins to slide as normal impulses push it.
    const double direction = tangent_speed > 0.0 || (tangent_speed == 0.0 && c < 0.0) ? -1.0 : 1.0;
    const double sliding = direction * friction;
    if (const double effect = a + sliding * c; effect > 0.0) {
        const double x = -normal_speed / effect;
        if ((tangent_speed + x * (c + sliding * b)) * tangent_speed > 0.0) return x;
    }

    // Friction holds the point, unless normal impulses turn the sliding around.
    const bool may_turn = friction * b < std::abs(c);
    if (const double determinant = a * b - c * c; determinant > kSingularDeterminant * a * b) {
        const double x = (c * tangent_speed - b * normal_speed) / determinant;
        const double tangent = (c * normal_speed - a * tangent_speed) / determinant;
        if (!may_turn || direction * tangent >= 0.0 || std::abs(tangent) <= friction * x) return x;
    }
    const double effect = may_turn ? a - sliding * c : a;
    return -normal_speed / (effect > 0.0 ? effect : a);
}

}  // namespace tumble
