#include "render/frame/forces.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::render {

namespace {

constexpr double kMostUnits = 5.0;                       // the force of an impact has an arrow of this many units
constexpr double kLeastForce = 1e-9, kMostForce = 1e30;  // N

// The 1, 2 or 5 times a power of ten that is nearest below.
double rounded_down(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const double mantissa = value / power;
    return (mantissa >= 5.0 ? 5.0 : mantissa >= 2.0 ? 2.0 : 1.0) * power;
}

}  // namespace

double force_unit(const World& world) {
    constexpr double kEarth = 10.0;  // m/s^2, in a world without gravity
    double mass = 0.0, count = 0.0;
    for (const BodyId body : world.bodies()) {
        if (world.type(body) != BodyType::dynamic_body) continue;
        mass += double{world.mass(body).mass};
        count += 1.0;
    }
    const double gravity = length(DVec2(world.def().gravity));
    const double weight = mass / std::max(count, 1.0) * (gravity > 0.0 ? gravity : kEarth);
    return rounded_down(std::clamp(weight, kLeastForce, kMostForce));
}

void add_forces(Marks& marks, const View& view, const World& world, Color color) {
    const double pixels_per_newton = marks.pixels(kForceLength) / force_unit(world);
    const double steps_per_second = world.def().steps_per_second;
    for (const ContactPoint& point : world.contacts()) {
        const DVec2 normal(point.normal), clockwise{normal.y, -normal.x};
        const DVec2 on_b =
            steps_per_second * (double{point.normal_impulse} * normal + double{point.tangent_impulse} * clockwise);
        const double size = length(on_b) * pixels_per_newton;
        if (size == 0.0) continue;
        const DVec2 arrow = (std::min(size, kMostUnits * marks.pixels(kForceLength)) / length(on_b)) * on_b;
        const DVec2 at = view.to_pixels(point.point);
        if (world.type(point.body_b) != BodyType::static_body) marks.arrow(at, at + arrow, color);
        if (world.type(point.body_a) != BodyType::static_body) marks.arrow(at, at - arrow, color);
    }
}

}  // namespace tumble::render
