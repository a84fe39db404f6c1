// Measures of a sound scene, which the lints apply before a run and the checks of its health while it runs.
#pragma once

#include "tumble/shape.hpp"
#include "tumble/world.hpp"

namespace tumble::scene {

inline constexpr double kLargeMassRatio = 100.0;
inline constexpr double kWideGap = 0.1;      // of a joint, of the size of its smaller body
inline constexpr double kVisibleSag = 0.05;  // of the smallest extent of the body that sinks

// m, in a world of scale 1: the range of body sizes in which the constants of the solver are tested.
inline constexpr double kSmallestBody = 0.005, kLargestBody = 100.0;

// The mass of the heavier body over that of the lighter one.
double mass_ratio(const World& world, BodyId a, BodyId b);

// The least distance of two parallel lines with the shape between them (m).
double width_of(const Shape& shape);

// The smallest side of the boxes of the body's shapes (m); of a segment its length. Infinite without shapes.
double smallest_extent(const World& world, BodyId body);

// The largest side of the boxes of the body's shapes (m); 0 without shapes.
double largest_extent(const World& world, BodyId body);

// The smaller of the sizes of two bodies (m). The size of a body without shapes is not known, and does not count.
double smaller_size(double size_a, double size_b);

// How deep two bodies may overlap at the start (m), of which the smaller has this smallest extent.
double allowed_overlap(double smallest_extent, double scale);

}  // namespace tumble::scene
