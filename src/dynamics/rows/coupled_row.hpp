// One constraint on the motions of two rows, each between two bodies of its own: the two sides of a pulley's rope, or
// the two joints of a gear.
//
// The velocity of a coupled row is v_first + ratio v_second. An impulse P along it is P along the first row and ratio P
// along the second. solve_equality() of joint_row.hpp works on coupled rows too.
#pragma once

#include <array>
#include <span>

#include "debug/check.hpp"
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

// A row at one of its bodies: the derivative of the row's velocity by the velocity of that body.
struct RowEnd {
    std::uint32_t body = kStaticSolverBody;
    Vec2 inv_mass;
    float inv_inertia = 0.0f;
    Vec2 axis;
    float angular = 0.0f;
    Vec2 arm;  // from the centre of mass to where the row acts, m
};
inline std::array<RowEnd, 2> row_ends(const JointBodies& joint, const JointRow& row) {
    return {{{joint.a, joint.inv_mass_a, joint.inv_inertia_a, -row.axis, -row.angular_a, row.arm_a},
             {joint.b, joint.inv_mass_b, joint.inv_inertia_b, row.axis, row.angular_b, row.arm_b}}};
}

// K_12: the change of the second row's velocity by a unit impulse along the first. It is not 0 if the two rows share a
// body: the carrier of two wheels, or the wheel between two others.
inline float shared_response(const CoupledBodies& joint, const CoupledRow& row) {
    float response = 0.0f;
    for (const RowEnd& one : row_ends(joint.first, row.first))
        for (const RowEnd& other : row_ends(joint.second, row.second))
            if (one.body == other.body)
                response +=
                    dot(scaled(one.inv_mass, one.axis), other.axis) + one.inv_inertia * one.angular * other.angular;
    return response;
}

inline float dead_response(const CoupledBodies& joint, const CoupledRow& row) {
    return dead_response(joint.first, row.first) + joint.ratio * joint.ratio * dead_response(joint.second, row.second);
}

// Effective mass, kg or kg m^2: 1 / K with K = K_11 + 2 ratio K_12 + ratio^2 K_22. Two rows that cancel each other have
// K = 0 but for rounding, some 2^-24 of K_11 + ratio^2 K_22: their effective mass is 0, so that no impulse acts.
inline float row_mass(const CoupledBodies& joint, const CoupledRow& row) {
    const float ratio_sq = joint.ratio * joint.ratio;
    const float uncoupled =
        row_response(joint.first, row.first, row.first) + ratio_sq * row_response(joint.second, row.second, row.second);
    const float response = uncoupled + 2.0f * joint.ratio * shared_response(joint, row);
    TUMBLE_CHECK(!(uncoupled < 0.0f));
    if (!(response > 1e-5f * uncoupled)) return 0.0f;
    if (joint.first.locked_mass + joint.second.locked_mass == 0.0f) return 1.0f / response;
    return damped_inverse(response, dead_response(joint, row));
}

}  // namespace tumble
