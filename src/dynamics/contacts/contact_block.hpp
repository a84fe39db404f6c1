// Eight contact constraints side by side: every quantity is an array of lanes. ContactSolver calls these functions.
//
// The offset r of a contact point from a centre of mass is stored in the contact's frame: `along` = r . n and `across`
// = r x n. The solver needs no other geometry: with the tangent t = -perp(n), r x t = -(r . n), and the offset rotated
// by (c, s) has the normal component c along + s across.
//
// An absent point has the separation kAbsentGap, so that it never gets an impulse. An unused lane has two absent points
// on the static body. There is no second, scalar kernel.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/bodies/body_lanes.hpp"
#include "dynamics/bodies/softness.hpp"
#include "dynamics/bodies/solver_body.hpp"
#include "dynamics/contacts/constraint_graph.hpp"
#include "tasks/crew.hpp"

namespace tumble {

// m; no velocity closes this gap in a sub-step, and its square is finite.
inline constexpr float kAbsentGap = 1e6f;

// Members that a pass writes are adjacent: with many contacts, a step takes as long as the transfer of cache lines.
struct ContactBlockPoint {
    Lanes along_a, across_a;  // m
    Lanes along_b, across_b;
    Lanes separation;      // at the start of the step, m
    Lanes inverse_mass;    // effective, along the normal, 1/kg; 1 for an absent point
    Lanes normal_impulse;  // N s, of this sub-step
    Lanes applied_normal;  // N s, summed over the sub-steps so far
    Lanes tangent_impulse;
    Lanes applied_tangent;
    Lanes tangent_mass;
};

// The inverse masses of bodies that may be locked along a world axis, 1/kg.
struct LockedMasses {
    Lanes ax, ay, bx, by;   // along the world axes
    Lanes normal, tangent;  // of both bodies, along normal and tangent
    Lanes least_response;   // a row with a smaller response is not solved
};

// What few blocks have. It is apart from the block, as a step takes as long as the transfer of the blocks' bytes.
struct ContactExtras {
    LockedMasses locked;
    Lanes radius_a, radius_b;  // of the shapes' rounding, m
    // With restitution: see RESTITUTION.md.
    Lanes restitution;
    Lanes approach_speed[2];  // of each point: its normal velocity at the impact, m/s, negative if it approaches
    Lanes absorbed;           // energy that the normal impulses of this step absorbed, J
    Lanes friction_work;      // work that friction did in this step, J
    Lanes acceleration;       // normal, of B's centre relative to A's without constraints, m/s^2
    Lanes tangent_speed;
    Lanes rolling_resistance;  // m
    Lanes rolling_mass;        // kg m^2
    Lanes rolling_impulse;     // N m s
};

struct ContactBlock {
    BodyRow body_a[kLaneCount];
    BodyRow body_b[kLaneCount];
    Lanes normal_x, normal_y;      // from A to B
    Lanes inv_mass_a, inv_mass_b;  // 1/kg, of bodies without locks
    Lanes inv_inertia_a, inv_inertia_b;
    ContactBlockPoint points[2];
    Lanes coupling;  // change of the normal velocity at one point per unit normal impulse at the other, 1/kg
    Lanes friction;
    Softness softness;
    std::uint8_t moved_a, moved_b;  // a bit for each lane whose body the contact can move
    std::uint8_t overlaps;          // a bit for each lane whose shapes overlapped when the step began
    // True if one of the lanes has it. Members of `extras` are valid only if their flag is set.
    bool has_locks;
    bool has_radius;
    bool has_restitution;
    bool has_tangent_speed;
    bool has_rolling_resistance;
    ContactExtras* extras;
};

// The normal impulse that bounds friction in the pass without bias: that of the pass with bias, which also pushes
// overlap out, or the one that the rigid rows ask for.
enum class FrictionBound : std::uint8_t { biased, rigid };

// What makes shapes bounce: apply_restitution(), or continuous collision at the time of the impact. Only the former
// needs to know the work of impulses.
enum class BounceBy : std::uint8_t { solver, impacts };

// Fills the blocks, one for each block of the graph, from manifolds and bodies. Each block refers to the extras of the
// same index. `h` is the sub-step, s.
void prepare_contacts(std::span<const Contact> contacts, const BodyStore& bodies, const ConstraintGraph& graph,
                      const Tuning& tuning, Vec2 gravity, float h, BounceBy bounces, std::vector<ContactBlock>& blocks,
                      std::vector<ContactExtras>& extras, Crew& crew);

// Writes the impulses of a region into its contacts: those of the last sub-step, which warm start the next step, and
// those of the whole step, which are reported.
void store_impulses(const std::vector<ContactBlock>& blocks, const ConstraintGraph& graph,
                    const ConstraintGraph::Region& region, std::span<Contact> contacts, std::span<SolverBody> bodies,
                    Crew& crew);

// Applies the accumulated impulses again.
void warm_start_contacts(std::span<ContactBlock> blocks, std::span<SolverBody> bodies);

// The pass with bias: normal impulses that remove overlap softly, at most at the push-out speed (m/s).
void solve_contacts(std::span<ContactBlock> blocks, std::span<SolverBody> bodies, float inv_h, float push_out_speed);

// The pass without bias: friction, rolling resistance, and rigid normal impulses, which remove the velocity of the
// bias.
void relax_contacts(std::span<ContactBlock> blocks, std::span<SolverBody> bodies, float inv_h, FrictionBound bound);

// Bounces: once after the sub-steps, for points where an impulse stopped an approach faster than `threshold` (m/s).
// `returned_work` is what find_returned_work() found: see RESTITUTION.md, step 10.
void apply_restitution(std::span<ContactBlock> blocks, std::span<SolverBody> bodies, float threshold, float h,
                       std::span<const float> returned_work);

// The work that contacts did on each dynamic body in this step instead of absorbing energy, by solver body, J.
void find_returned_work(std::span<const ContactBlock> blocks, std::span<float> returned_work);

}  // namespace tumble
