// Eight contact constraints side by side, as the solver sees them: every quantity is an array of lanes.
//
// Contact points are kept by their offsets from the centres of mass in the contact's own frame: `along` = r . n and
// `across` = r x n. They are all the geometry there is: with the tangent t = -perp(n), r x t = -(r . n), and the
// offset turned by (c, s) has the normal component c along + s across.
//
// A point that is not there is kAbsentGap away, so that it never carries. Unused lanes are neutral: two such points on
// the static body. There is no second, scalar kernel.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/bodies/softness.hpp"
#include "dynamics/bodies/solver_body.hpp"
#include "dynamics/contacts/constraint_graph.hpp"
#include "simd/lanes.hpp"

namespace tumble {

// m; so far that no velocity closes it in a sub-step, and its square is still finite.
inline constexpr float kAbsentGap = 1e6f;

// What a pass writes stands together: a step of many contacts takes as long as their cache lines.
struct ContactBlockPoint {
    Lanes along_a, across_a;  // m
    Lanes along_b, across_b;
    Lanes separation;      // at the start of the step, m
    Lanes inverse_mass;    // effective, along the normal, 1/kg; 1 for a point that is not there
    Lanes normal_impulse;  // N s, of the present sub-step
    Lanes applied_normal;  // N s, of the step so far: each sub-step ends with the impulse that it has applied in all
    Lanes tangent_impulse;
    Lanes applied_tangent;
    Lanes tangent_mass;
    Lanes carried;  // the normal impulse with which the step began
};

struct ContactBlock {
    std::uint32_t body_a[kLaneCount];  // solver bodies
    std::uint32_t body_b[kLaneCount];
    Lanes normal_x, normal_y;        // from A to B
    Lanes inv_mass_ax, inv_mass_ay;  // along the axes of the world: bodies may be locked
    Lanes inv_mass_bx, inv_mass_by;
    Lanes linear_normal, linear_tangent;  // of both bodies together, along normal and tangent
    Lanes inv_inertia_a, inv_inertia_b;
    ContactBlockPoint points[2];
    Lanes coupling;  // what a normal impulse at one point does to the velocity at the other, 1/kg
    Lanes friction;
    Softness softness;
    // The rest is read only if one of the lanes has it.
    bool has_locks;
    Lanes least_response;  // below which bodies that are locked do not give way, 1/kg
    bool has_radius;
    bool has_restitution;
    bool has_tangent_speed;
    bool has_rolling_resistance;
    Lanes radius_a, radius_b;  // of the shapes' rounding, m
    Lanes restitution;
    Lanes approach_speed[2];  // of each point: normal velocity at the impact, negative if approaching; with restitution
                              // only
    Lanes absorbed;           // work that the normal impulses of this step have taken, J; with restitution only
    Lanes friction_work;      // work that friction has done in this step against its surfaces, J; with restitution only
    Lanes acceleration;  // along the normal, of B's centre against A's if nothing were in their way; with restitution
                         // only
    Lanes tangent_speed;
    Lanes rolling_resistance;  // m
    Lanes rolling_mass;        // kg m^2
    Lanes rolling_impulse;     // N m s
};

// Fills one block per block of the graph from manifolds and bodies.
void prepare_contacts(std::span<const Contact> contacts, const BodyStore& bodies, const ConstraintGraph& graph,
                      const Tuning& tuning, Vec2 gravity, float h, std::vector<ContactBlock>& blocks);

// Takes the impulses back: those of the last sub-step, which warm the next step, and of the whole step, which are told.
void store_impulses(const std::vector<ContactBlock>& blocks, const ConstraintGraph& graph, std::span<Contact> contacts);

// Applies the impulses of the last sub-step again.
void warm_start_contacts(std::span<ContactBlock> blocks, std::span<SolverBody> bodies);

// Normal impulses with the soft bias that removes overlap, no faster than the push-out speed.
void solve_contacts(std::span<ContactBlock> blocks, std::span<SolverBody> bodies, float inv_h, float push_out_speed);

// Normal impulses without the bias, which take its velocity away again; friction and rolling resistance.
void relax_contacts(std::span<ContactBlock> blocks, std::span<SolverBody> bodies, float inv_h);

// Bounces: once after the sub-steps, where an impulse stopped an approach faster than the threshold.
// `given` is room to work in, by solver body.
void apply_restitution(std::span<ContactBlock> blocks, std::span<SolverBody> bodies, float threshold, float h,
                       std::vector<float>& given);

}  // namespace tumble
