// Two rows that move as one, each with two bodies of its own: the two sides of a rope, or of a gear's teeth.
//
// The velocity of a coupled row is v_first + ratio v_second, and an impulse P acts on the first row by P and on the
// second by ratio P. What a single row can do for an equality (joint_row.hpp), it can do.
#pragma once

#include <array>
#include <span>

#include "dynamics/rows/joint_row.hpp"

namespace tumble {

struct CoupledBodies {
    JointBodies first, second;
    float ratio = 1.0f;
};

struct CoupledRow {
    JointRow first, second;
};

inline float row_velocity(const CoupledBodies& joint, const CoupledRow& row, std::span<const SolverBody> all) {
    return row_velocity(joint.first, row.first, all) + joint.ratio * row_velocity(joint.second, row.second, all);
}

inline void apply_row(const CoupledBodies& joint, const CoupledRow& row, float impulse, std::span<SolverBody> all) {
    apply_row(joint.first, row.first, impulse, all);
    apply_row(joint.second, row.second, joint.ratio * impulse, all);
}

// A row at one of its bodies: how the row's velocity depends on that body's.
struct RowEnd {
    std::uint32_t body = kStaticSolverBody;
    Vec2 inv_mass;
    float inv_inertia = 0.0f;
    Vec2 axis;
    float turn = 0.0f;
};
inline std::array<RowEnd, 2> row_ends(const JointBodies& joint, const JointRow& row) {
    return {{{joint.a, joint.inv_mass_a, joint.inv_inertia_a, -row.axis, -row.turn_a},
             {joint.b, joint.inv_mass_b, joint.inv_inertia_b, row.axis, row.turn_b}}};
}

// What a unit impulse along the one row does to the velocity of the other, by the bodies that both have: the carrier of
// two wheels, or the wheel between two others.
inline float shared_response(const CoupledBodies& joint, const CoupledRow& row) {
    float response = 0.0f;
    for (const RowEnd& one : row_ends(joint.first, row.first))
        for (const RowEnd& other : row_ends(joint.second, row.second))
            if (one.body == other.body)
                response += dot(scaled(one.inv_mass, one.axis), other.axis) + one.inv_inertia * one.turn * other.turn;
    return response;
}

// As for a single row: K = K_11 + 2 ratio K_12 + ratio^2 K_22. It is 0 where the two rows are one motion, and what
// rounding leaves of it, some 2^-24 of K_11 + ratio^2 K_22, must not count.
inline float row_mass(const CoupledBodies& joint, const CoupledRow& row) {
    const float ratio_sq = joint.ratio * joint.ratio;
    const float apart =
        row_response(joint.first, row.first, row.first) + ratio_sq * row_response(joint.second, row.second, row.second);
    const float response = apart + 2.0f * joint.ratio * shared_response(joint, row);
    if (!(response > 1e-5f * apart)) return 0.0f;
    if (joint.first.locked_mass + joint.second.locked_mass == 0.0f) return 1.0f / response;
    return damped_inverse(response,
                          dead_response(joint.first, row.first) + ratio_sq * dead_response(joint.second, row.second));
}

}  // namespace tumble
