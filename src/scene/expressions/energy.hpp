// The energy and the momentum of the dynamic bodies of a world.
#pragma once

#include "tumble/world.hpp"

namespace tumble::scene {

struct Energy {
    double kinetic = 0.0;    // J
    double potential = 0.0;  // J in the gravity of the world; 0 for a centre of mass at the origin
    double total() const { return kinetic + potential; }
};

Energy energy_of(const World& world);
Energy energy_of(const World& world, BodyId body);  // 0 if the body is not dynamic

DVec2 momentum_of(const World& world);  // kg m/s

}  // namespace tumble::scene
