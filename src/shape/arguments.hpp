// The checks of the factories' arguments. Each throws std::invalid_argument that prints the offending value.
#pragma once

#include <cstddef>
#include <span>

#include "tumble/math.hpp"

namespace tumble {

void require_vertex_count(std::size_t count);  // at most Shape::kMaxVertices
void require_radius(float radius);             // finite and not negative
void require_finite(const char* what, Vec2 point);
void require_finite(const char* what, double value);
void require_points(std::span<const Vec2> points, std::size_t at_least);  // enough of them, each finite
void require_box(Vec2 size, float radius);

}  // namespace tumble
