// Restitution, once after the sub-steps. RESTITUTION.md derives the formulas; steps refer to it.
#include <algorithm>

#include "debug/check.hpp"
#include "dynamics/bodies/ballistics.hpp"
#include "dynamics/contacts/contact_normals.hpp"

namespace tumble {

namespace {

// How a point bounces.
struct Bounce {
    Lanes happens;  // 1 or 0
    Lanes speed;    // normal velocity after the bounce, m/s
    Lanes part;     // of the absorbed energy that it may return
};

// Steps 3, 5 and 9.
TUMBLE_LANE_FUNCTION Bounce make_bounce(const ContactBlock& block, int index, const Lanes& shift, float threshold,
                                        float h, const BlockState& state) {
    const ContactBlockPoint& point = block.points[index];
    const Lanes& approach = block.extras->approach_speed[index];
    const Lanes zero = Lanes::Zero(), one = Lanes::Ones();
    // Other lanes of the block may have restitution.
    const Lanes may_bounce = select_less(zero, block.extras->restitution, one, zero);
    const Lanes was_fast = select_less(approach, Lanes::Constant(-threshold), may_bounce, zero);
    const Lanes happens = select_less(zero, point.applied_normal, was_fast, zero);
    const Lanes rebound = block.extras->restitution * approach;
    const Lanes separation = current_separation(block, point, shift, state);
    const Lanes speed_sq = larger(speed_sq_after(rebound, separation, block.extras->acceleration), zero);
    const Lanes speed = square_root(speed_sq) - 0.5f * h * block.extras->acceleration;
    const Lanes free_sq = speed_sq_after(approach, separation, block.extras->acceleration);
    return {happens, speed, select_less(zero, happens * free_sq, speed * speed / free_sq, zero)};
}

// Points that do not bounce keep their impulses.
TUMBLE_LANE_FUNCTION NormalRow make_bounce_row(const ContactBlockPoint& point, const Bounce& bounce,
                                               const BlockState& state) {
    const Lanes zero = Lanes::Zero();
    const Lanes missing = select_less(zero, bounce.happens, normal_velocity(point, state) - bounce.speed, zero);
    return {point.inverse_mass, missing - point.inverse_mass * point.normal_impulse};
}

// The largest factor t <= 1 with which the impulses x do no more work than `energy` (step 12).
TUMBLE_LANE_FUNCTION Lanes affordable_part(const ContactBlock& block, const Lanes& x1, const Lanes& x2,
                                           const Lanes& energy, const BlockState& state) {
    const Lanes zero = Lanes::Zero(), one = Lanes::Ones();
    const Lanes linear = power(block, x1, x2, state);
    const Lanes square = x1 * x1 * block.points[0].inverse_mass + 2.0f * x1 * x2 * block.coupling +
                         x2 * x2 * block.points[1].inverse_mass;
    const Lanes root = square_root(linear * linear + 2.0f * square * larger(energy, zero));
    return smaller(select_less(zero, square, larger(root - linear, zero) / square, one), one);
}

// Both points at once (step 6), limited to the energy that the contact may return (step 11). `returned` is the work
// that other contacts of the two bodies returned, J.
TUMBLE_LANE_FUNCTION void solve_restitution(ContactBlock& block, float threshold, float h, const Lanes& returned,
                                            BlockState& state) {
    const Lanes shift = center_shift(block, state);
    const Bounce first = make_bounce(block, 0, shift, threshold, h, state);
    const Bounce second = make_bounce(block, 1, shift, threshold, h, state);
    const NormalRow row1 = make_bounce_row(block.points[0], first, state);
    const NormalRow row2 = make_bounce_row(block.points[1], second, state);
    Lanes change1, change2;
    find_changes(block, block.coupling * first.happens * second.happens, row1, row2, change1, change2);
    change1 = select_less(Lanes::Zero(), first.happens, change1, Lanes::Zero());
    change2 = select_less(Lanes::Zero(), second.happens, change2, Lanes::Zero());
    const Lanes absorbed = block.extras->absorbed - larger(block.extras->friction_work, Lanes::Zero()) - returned;
    const Lanes energy = larger(first.part, second.part) * absorbed;
    const Lanes part = affordable_part(block, change1, change2, energy, state);
    TUMBLE_CHECK(!(part > 1.0f).any());
    TUMBLE_CHECK(!(part < 0.0f).any());
    const Lanes bounce1 = part * change1, bounce2 = part * change2;
    change_normals(block, bounce1, bounce2, state);
    block.points[0].applied_normal += bounce1;
    block.points[1].applied_normal += bounce2;
}

Lanes sum_of_both(const ContactBlock& block, std::span<const float> returned_work) {
    Lanes sum;
    for (int lane = 0; lane < kLaneCount; ++lane)
        sum[lane] = returned_work[block.body_a[lane].index()] + returned_work[block.body_b[lane].index()];
    return sum;
}

}  // namespace

// Step 10.
void find_returned_work(std::span<const ContactBlock> blocks, std::span<float> returned_work) {
    std::fill(returned_work.begin(), returned_work.end(), 0.0f);
    for (const ContactBlock& block : blocks) {
        if (!block.has_restitution) continue;
        for (int lane = 0; lane < kLaneCount; ++lane) {
            TUMBLE_CHECK(block.body_a[lane].index() < returned_work.size());
            TUMBLE_CHECK(block.body_b[lane].index() < returned_work.size());
            if (!(block.extras->restitution[lane] > 0.0f)) continue;
            const float work = std::max(-block.extras->absorbed[lane], 0.0f);
            if (block.moved_a >> lane & 1) returned_work[block.body_a[lane].index()] += work;
            if (block.moved_b >> lane & 1) returned_work[block.body_b[lane].index()] += work;
        }
    }
}

void apply_restitution(std::span<ContactBlock> blocks, std::span<SolverBody> bodies, float threshold, float h,
                       std::span<const float> returned_work) {
    TUMBLE_CHECK(h > 0.0f);
    for (ContactBlock& block : blocks) {
        if (!block.has_restitution) continue;
        BlockState state = load(block, bodies);
        solve_restitution(block, threshold, h, sum_of_both(block, returned_work), state);
        finish(block, state, bodies);
    }
}

}  // namespace tumble
