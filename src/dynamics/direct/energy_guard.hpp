// Keeps the kinetic energy of joined bodies while they move along their constraints.
//
// Equality constraints do no work, so the kinetic energy of a component after the projection of its velocities must be
// that before the chord (joint_system.hpp). The scheme keeps it but for terms of third order in rotation per sub-step;
// these are large where a light body whips, and then the energy would grow without bound. The guard scales the
// velocities of a component to the energy that it must have. If something else has changed them in between (contacts,
// drives, speed limits), it only takes energy away that the joints have added.
//
// The velocities of a component that hangs on nothing are scaled relative to its centre of mass: its momentum stays.
// Those of a component that a kinematic body drives are left alone, as that body does work.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/bodies/solver_body.hpp"

namespace tumble {

// A body of the system: its solver body, its component and its masses (kg, kg m^2), 0 along a lock.
struct GuardedBody {
    std::uint32_t body = 0;
    std::uint32_t component = 0;
    double mass_x = 0.0, mass_y = 0.0, inertia = 0.0;
};

enum class Hold : std::uint8_t { free, fixed, driven };  // what the rows of a component hold on to

class EnergyGuard {
public:
    void reset(std::size_t component_count);
    void hold(std::uint32_t component, Hold hold) {
        components_[component].hold = std::max(components_[component].hold, hold);
    }

    // To be called in this order in each sub-step, around the two solutions of the system.
    void before_chord(std::span<const GuardedBody> guarded, std::span<const SolverBody> bodies);
    void after_chord(std::span<const GuardedBody> guarded, std::span<const SolverBody> bodies);
    void before_projection(std::span<const GuardedBody> guarded, std::span<const SolverBody> bodies);
    void after_projection(std::span<const GuardedBody> guarded, std::span<SolverBody> bodies);

    std::size_t bytes() const { return components_.capacity() * sizeof(Component); }

private:
    struct Component {
        // Measured last. The energy is that of the motion relative to the common velocity.
        double momentum_x = 0.0, momentum_y = 0.0, mass_x = 0.0, mass_y = 0.0;
        double energy = 0.0;  // kinetic, J
        double before = 0.0;  // the energy after the chord, J
        double work = 0.0;    // of the constraints in this sub-step, J
        double scale = 1.0;   // of the velocities
        Hold hold = Hold::free;
        bool is_undisturbed = true;  // nothing but the joints has changed the velocities since the chord

        // The velocity that scaling keeps: of the centre of mass of what is free, m/s.
        double common_x() const { return mass_x > 0.0 ? momentum_x / mass_x : 0.0; }
        double common_y() const { return mass_y > 0.0 ? momentum_y / mass_y : 0.0; }
    };
    void measure(std::span<const GuardedBody> guarded, std::span<const SolverBody> bodies);

    std::vector<Component> components_;
};

}  // namespace tumble
