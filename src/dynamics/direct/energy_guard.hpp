// Keeps the kinetic energy of joined bodies while they move along their constraints.
//
// Equality constraints do no work: after the projection a component must have the kinetic energy that it had before the
// chord (joint_system.hpp). The guard scales its velocities to that energy (JOINT_SYSTEM.md, steps 14 to 19). If
// contacts, drives or speed limits change the velocities in between, it only removes energy that the joints added.
//
// A component without a fixed body is scaled relative to its centre of mass, so that its momentum stays. A component
// that a kinematic body drives is not scaled: that body does work.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "debug/check.hpp"
#include "dynamics/bodies/solver_body.hpp"

namespace tumble {

// A body of the system: its solver body, its component and its masses (kg, kg m^2), 0 along a lock.
struct GuardedBody {
    std::uint32_t body = 0;
    std::uint32_t component = 0;
    double mass_x = 0.0, mass_y = 0.0, inertia = 0.0;
};

// What holds a component: nothing, a static body or a locked axis, or a kinematic body.
enum class Hold : std::uint8_t { free, fixed, driven };

class EnergyGuard {
public:
    void reset(std::size_t component_count);
    void hold(std::uint32_t component, Hold hold) {
        TUMBLE_CHECK(component < components_.size());
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
        // As measure() found them last. The energy is that of the motion relative to the common velocity.
        double momentum_x = 0.0, momentum_y = 0.0, mass_x = 0.0, mass_y = 0.0;
        double energy = 0.0;  // kinetic, J
        double before = 0.0;  // the energy after the chord, J
        double work = 0.0;    // of the constraints in this sub-step, J; exactly solved it would be 0
        double scale = 1.0;   // of the velocities
        Hold hold = Hold::free;
        bool is_undisturbed = true;  // nothing but the joints has changed the velocities since the chord

        // The velocity of the centre of mass, which scaling does not change, m/s; 0 if the component is not free.
        double common_x() const { return mass_x > 0.0 ? momentum_x / mass_x : 0.0; }
        double common_y() const { return mass_y > 0.0 ? momentum_y / mass_y : 0.0; }
    };
    void measure(std::span<const GuardedBody> guarded, std::span<const SolverBody> bodies);

    std::vector<Component> components_;
};

}  // namespace tumble
