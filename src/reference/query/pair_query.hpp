// A distance query as plain data: families generate it, engines answer it, reports print it.
#pragma once

#include <string>

#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble::reference {

struct PairQuery {
    Shape a, b;
    Pose pose_a, pose_b;  // world from shape

    // The same query for the bare cores.
    PairQuery without_radii() const;
    PairQuery swapped() const { return {b, a, pose_b, pose_a}; }
};

// True if every number is finite and both shapes have vertices. The exact oracle requires it.
bool is_finite(const PairQuery& query);

// The largest absolute world coordinate of a vertex or position, radii added: S of the parity tolerances (m).
double largest_coordinate(const PairQuery& query);

// RA + RB + |p| (m): the core radii about the origins of the shapes, and the offset of the positions. Rounding errors
// of the narrow phase are proportional to it.
double error_scale(const PairQuery& query);

// The same with |q| of each rotation replaced by its upper bound (1 + |q|^2) / 2 (m). The error bound of the narrow
// phase is proportional to it. Equal to error_scale() for rotations of unit length.
double bound_scale(const PairQuery& query);

// u (RA + RB + |p| + rA + rB) (m), with u = 2^-53 and the radii rA and rB: the unit in which errors of the narrow phase
// are stated.
double error_unit(const PairQuery& query);

// All numbers as hexadecimal floats, which state the query bit for bit.
std::string to_hex(const PairQuery& query);

}  // namespace tumble::reference
