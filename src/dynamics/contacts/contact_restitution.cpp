// Bounces: what was approaching fast parts again, once after the sub-steps.
#include <algorithm>

#include "dynamics/bodies/ballistics.hpp"
#include "dynamics/contacts/contact_normals.hpp"

namespace tumble {

namespace {

// How a point bounces: where an impulse stopped an approach fast enough.
struct Bounce {
    Lanes happens;  // 1 or 0
    Lanes speed;    // with which it is to part
    Lanes part;     // of the energy that it took, by Newton's law of restitution
};

// A bouncing point is to part with e times the speed of its impact where it met: at a separation s under the
// acceleration a with (v + a h / 2)^2 = (e v_impact)^2 + 2 a s, as in set_approaches().
TUMBLE_LANE_FUNCTION Bounce make_bounce(const ContactBlock& block, int index, const Lanes& shift, float threshold,
                                        float h, const BlockState& state) {
    const ContactBlockPoint& point = block.points[index];
    const Lanes& approach = block.approach_speed[index];
    const Lanes zero = Lanes::Zero(), one = Lanes::Ones();
    const Lanes was_fast = select_less(approach, Lanes::Constant(-threshold), one, zero);
    const Lanes happens = select_less(zero, point.applied_normal, was_fast, zero);
    const Lanes back = block.restitution * approach;
    const Lanes way = current_separation(block, point, shift, state);
    const Lanes speed_sq = speed_sq_after(back, way, block.acceleration).max(zero);
    const Lanes speed = speed_sq.sqrt() - 0.5f * h * block.acceleration;
    const Lanes arrived = speed_sq_after(approach, way, block.acceleration);
    return {happens, speed, select_less(zero, happens * arrived, speed * speed / arrived, zero)};
}

// Others keep their impulses.
TUMBLE_LANE_FUNCTION NormalRow make_bounce_row(const ContactBlockPoint& point, const Bounce& bounce,
                                               const BlockState& state) {
    const Lanes zero = Lanes::Zero();
    const Lanes missing = select_less(zero, bounce.happens, normal_velocity(point, state) - bounce.speed, zero);
    return {point.inverse_mass, missing - point.inverse_mass * point.normal_impulse};
}

// How much of the impulses x may be applied if they are to do no more work than s x . v + s^2 x . A x / 2 = energy.
TUMBLE_LANE_FUNCTION Lanes affordable_part(const ContactBlock& block, const Lanes& x1, const Lanes& x2,
                                           const Lanes& energy, const BlockState& state) {
    const Lanes zero = Lanes::Zero(), one = Lanes::Ones();
    const Lanes linear = power(block, x1, x2, state);
    const Lanes square = x1 * x1 * block.points[0].inverse_mass + 2.0f * x1 * x2 * block.coupling +
                         x2 * x2 * block.points[1].inverse_mass;
    const Lanes root = (linear * linear + 2.0f * square * energy.max(zero)).sqrt();
    return select_less(zero, square, (root - linear).max(zero) / square, one).min(one);
}

// Both points at once: one after the other they would make a box that falls flat spin. What Newton's law asks for may
// be more than the impact took, where bodies turn while they meet or meet several others: no more is given back than
// that part of it [Stronge 1990, "Rigid body collisions with friction"], less what friction has given already while it
// stopped a surface that the impact drove along, and other contacts while they pushed the bodies into this one. A gas
// of ten balls grew by 4 % in a minute without.
TUMBLE_LANE_FUNCTION void solve_restitution(ContactBlock& block, float threshold, float h, const Lanes& given,
                                            BlockState& state) {
    const Lanes shift = center_shift(block, state);
    const Bounce first = make_bounce(block, 0, shift, threshold, h, state);
    const Bounce second = make_bounce(block, 1, shift, threshold, h, state);
    const NormalRow row1 = make_bounce_row(block.points[0], first, state);
    const NormalRow row2 = make_bounce_row(block.points[1], second, state);
    Lanes change1, change2;
    find_changes(block, block.coupling * first.happens * second.happens, row1, row2, change1, change2);
    const Lanes taken = block.absorbed - block.friction_work.max(Lanes::Zero()) - given;
    const Lanes energy = first.part.max(second.part) * taken;
    const Lanes part = affordable_part(block, change1, change2, energy, state);
    const Lanes bounce1 = part * change1, bounce2 = part * change2;
    change_normals(block, bounce1, bounce2, state);
    block.points[0].applied_normal += bounce1;
    block.points[1].applied_normal += bounce2;
}

// Work that contacts have done on each body in this step instead of taking it: by solver body, J. What is not dynamic
// gets none.
void find_given(std::span<const ContactBlock> blocks, std::span<float> given) {
    std::fill(given.begin(), given.end(), 0.0f);
    for (const ContactBlock& block : blocks) {
        if (!block.has_restitution) continue;
        for (int lane = 0; lane < kLaneCount; ++lane) {
            const float work = std::max(-block.absorbed[lane], 0.0f);
            if (block.inv_mass_ax[lane] + block.inv_mass_ay[lane] > 0.0f) given[block.body_a[lane]] += work;
            if (block.inv_mass_bx[lane] + block.inv_mass_by[lane] > 0.0f) given[block.body_b[lane]] += work;
        }
    }
}

Lanes given_to_both(const ContactBlock& block, std::span<const float> given) {
    Lanes sum;
    for (int lane = 0; lane < kLaneCount; ++lane) sum[lane] = given[block.body_a[lane]] + given[block.body_b[lane]];
    return sum;
}

}  // namespace

void apply_restitution(std::span<ContactBlock> blocks, std::span<SolverBody> bodies, float threshold, float h,
                       std::vector<float>& given) {
    if (std::none_of(blocks.begin(), blocks.end(), [](const ContactBlock& block) { return block.has_restitution; }))
        return;
    given.resize(bodies.size());
    find_given(blocks, given);
    for (ContactBlock& block : blocks) {
        if (!block.has_restitution) continue;
        BlockState state = load(block, bodies);
        solve_restitution(block, threshold, h, given_to_both(block, given), state);
        finish(block, state, bodies);
    }
}

}  // namespace tumble
