#include "dynamics/direct/energy_guard.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"

namespace tumble {

namespace {

// The most energy that the guard adds to a component in a sub-step, as a part of the component's energy. Where the
// scheme is accurate it loses less. A greater loss means that the scheme is not accurate, and is not made up for.
constexpr double kLargestGain = 0.01;

}  // namespace

void EnergyGuard::reset(std::size_t component_count) { components_.assign(component_count, {}); }

void EnergyGuard::measure(std::span<const GuardedBody> guarded, std::span<const SolverBody> bodies) {
    for (Component& component : components_)
        component.energy = component.momentum_x = component.momentum_y = component.mass_x = component.mass_y = 0.0;
    for (const GuardedBody& one : guarded) {
        TUMBLE_CHECK(one.body < bodies.size());
        TUMBLE_CHECK(one.component < components_.size());
        TUMBLE_CHECK(one.mass_x >= 0.0);
        TUMBLE_CHECK(one.mass_y >= 0.0);
        TUMBLE_CHECK(one.inertia >= 0.0);
        Component& component = components_[one.component];
        if (component.hold != Hold::free) continue;
        component.momentum_x += one.mass_x * double{bodies[one.body].velocity.x};
        component.momentum_y += one.mass_y * double{bodies[one.body].velocity.y};
        component.mass_x += one.mass_x;
        component.mass_y += one.mass_y;
    }
    for (const GuardedBody& one : guarded) {
        const SolverBody& body = bodies[one.body];
        Component& component = components_[one.component];
        const double x = double{body.velocity.x} - component.common_x(),
                     y = double{body.velocity.y} - component.common_y();
        const double spin = body.angular_velocity;
        component.energy += 0.5 * (one.mass_x * x * x + one.mass_y * y * y + one.inertia * spin * spin);
    }
}

void EnergyGuard::before_chord(std::span<const GuardedBody> guarded, std::span<const SolverBody> bodies) {
    measure(guarded, bodies);
    for (Component& component : components_) component.work = -component.energy;
}

void EnergyGuard::after_chord(std::span<const GuardedBody> guarded, std::span<const SolverBody> bodies) {
    measure(guarded, bodies);
    for (Component& component : components_) {
        component.work += component.energy;
        component.before = component.energy;
    }
}

void EnergyGuard::before_projection(std::span<const GuardedBody> guarded, std::span<const SolverBody> bodies) {
    measure(guarded, bodies);
    for (Component& component : components_) {
        component.work -= component.energy;
        component.is_undisturbed = component.energy == component.before;
    }
}

void EnergyGuard::after_projection(std::span<const GuardedBody> guarded, std::span<SolverBody> bodies) {
    measure(guarded, bodies);
    for (Component& component : components_) {
        const double work = component.work + component.energy;
        component.scale = 1.0;
        if (component.hold == Hold::driven || !(component.energy > 0.0)) continue;
        if (work < 0.0 && !component.is_undisturbed) continue;
        component.scale = std::sqrt(std::clamp(1.0 - work / component.energy, 0.0, 1.0 + kLargestGain));
    }
    for (const GuardedBody& one : guarded) {
        const Component& component = components_[one.component];
        if (component.scale == 1.0) continue;
        SolverBody& body = bodies[one.body];
        const double x = component.common_x(), y = component.common_y(), scale = component.scale;
        body.velocity = {static_cast<float>(x + scale * (double{body.velocity.x} - x)),
                         static_cast<float>(y + scale * (double{body.velocity.y} - y))};
        body.angular_velocity = static_cast<float>(scale * double{body.angular_velocity});
    }
}

}  // namespace tumble
