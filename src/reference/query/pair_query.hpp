// One distance query as plain data: what generators make, engines answer, and reports print.
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

// True if every number is finite and both shapes have vertices: what an exact answer needs.
bool is_finite(const PairQuery& query);

// The largest absolute world coordinate of a vertex or position, radii added: S of the parity tolerances (m).
double largest_coordinate(const PairQuery& query);

// RA + RB + |p|, the length that the rounding errors of the narrow phase are proportional to: the core radii about each
// shape's origin and the offset of the positions (m).
double error_scale(const PairQuery& query);

// The same with |q| of each rotation at its upper bound (1 + |q|^2) / 2, as the narrow phase takes it: equal for
// rotations of unit length, and what its error bound is proportional to (m).
double bound_scale(const PairQuery& query);

// u (RA + RB + |p| + rA + rB), u = 2^-53 and rA, rB the radii: the unit in which errors of the narrow phase are stated
// (m).
double error_unit(const PairQuery& query);

// All numbers as hexadecimal floats, from which the query can be typed in again bit for bit.
std::string to_hex(const PairQuery& query);

}  // namespace tumble::reference
