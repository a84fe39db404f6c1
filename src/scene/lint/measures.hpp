// Measures that several lints share.
#pragma once

#include "tumble/shape.hpp"
#include "tumble/world.hpp"

namespace tumble::scene {

inline constexpr double kLargeMassRatio = 100.0;

// The mass of the heavier body over that of the lighter one.
double mass_ratio(const World& world, BodyId a, BodyId b);

// The least distance of two parallel lines with the shape between them (m).
double width_of(const Shape& shape);

}  // namespace tumble::scene
