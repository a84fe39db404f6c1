#include "tools/diff/trajectory_diff.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "tumble/math.hpp"

namespace tumble::tools {

namespace {

// The number of steps from one floating-point number to the next between a and b; both zeros count as one number.
template <class Integer, class Number>
std::uint64_t ulps_between(Number a, Number b) {
    const auto ordered = [](Number value) {
        const auto bits = std::bit_cast<Integer>(value);
        return bits < 0 ? std::numeric_limits<Integer>::min() - bits : bits;
    };
    const Integer x = ordered(a), y = ordered(b);
    return x > y ? static_cast<std::uint64_t>(x) - static_cast<std::uint64_t>(y)
                 : static_cast<std::uint64_t>(y) - static_cast<std::uint64_t>(x);
}

std::optional<std::size_t> first_differing(const NamedState& a, const NamedState& b, double tolerance) {
    for (std::size_t i = 0; i < kComponents.size(); ++i) {
        const double x = a.values[i], y = b.values[i];
        const bool same = x == y || difference_of(i, x, y) <= tolerance || (std::isnan(x) && std::isnan(y));
        if (!same) return i;
    }
    return std::nullopt;
}

StateDifference at_start_of(const BodyPair& pair, std::uint64_t step, double time) {
    StateDifference difference;
    difference.step = step;
    difference.time = time;
    difference.body = pair.names[0];
    difference.body_b = pair.names[1];
    return difference;
}

// The body is in one run in this step, and in the other run in other steps only.
StateDifference alone(const BodyPair& pair, std::uint64_t step, double time, Side side) {
    StateDifference difference = at_start_of(pair, step, time);
    difference.what = std::string("in this step only ") + (side == Side::a ? "A" : "B") + " has the body";
    return difference;
}

// The first difference of the bodies that both runs have had so far.
std::optional<StateDifference> compare_step(const std::vector<BodyPair>& pairs, const StepStates& a,
                                            const StepStates& b, double tolerance) {
    std::optional<StateDifference> first;
    std::size_t differing_bodies = 0;
    for (const BodyPair& pair : pairs) {
        const auto& [row_a, row_b] = pair.rows;
        if (!pair.is_in_both() || (!row_a && !row_b)) continue;
        if (!row_a || !row_b) {
            if (differing_bodies++ == 0) first = alone(pair, a.step, a.time, row_a ? Side::a : Side::b);
            continue;
        }
        const NamedState &in_a = a.bodies[*row_a], &in_b = b.bodies[*row_b];
        const std::optional<std::size_t> component = first_differing(in_a, in_b, tolerance);
        if (!component || differing_bodies++ > 0) continue;
        first = at_start_of(pair, a.step, a.time);
        first->component = *component;
        first->a = in_a.values[*component];
        first->b = in_b.values[*component];
    }
    if (first) first->differing_bodies = differing_bodies;
    return first;
}

StateDifference ends_early(const StepStates& longer, const char* shorter) {
    StateDifference difference;
    difference.step = longer.step;
    difference.time = longer.time;
    difference.what = std::string(shorter) + " ends before this step";
    return difference;
}

StateDifference out_of_step(const StepStates& a, const StepStates& b) {
    StateDifference difference;
    difference.step = a.step;
    difference.time = a.time;
    difference.what = "A continues with step " + std::to_string(a.step) + ", B with step " + std::to_string(b.step);
    return difference;
}

StepDifference largest_of(const std::vector<BodyPair>& pairs, const StepStates& a, const StepStates& b) {
    StepDifference largest;
    for (const BodyPair& pair : pairs) {
        if (!pair.rows[0] || !pair.rows[1]) continue;
        const NamedState &in_a = a.bodies[*pair.rows[0]], &in_b = b.bodies[*pair.rows[1]];
        for (std::size_t component = 0; component < kComponents.size(); ++component) {
            const double value = difference_of(component, in_a.values[component], in_b.values[component]);
            LargestDifference& so_far = largest[kKindOf[component]];
            if (value > so_far.value) so_far = {value, in_a.body, a.step};
        }
    }
    return largest;
}

// Compares the steps of both runs up to the end of the shorter one.
void compare_steps(StateSource& source_a, StateSource& source_b, double tolerance, BodyPairs& bodies,
                   Comparison& comparison, const StepObserver& observe) {
    const auto keep_first = [&](const StateDifference& difference) {
        if (!comparison.first) comparison.first = difference;
    };
    StepStates a, b;
    for (;;) {
        const bool more_a = source_a.next(a), more_b = source_b.next(b);
        if (!more_a && !more_b) return;
        if (more_a != more_b) return keep_first(more_a ? ends_early(a, "B") : ends_early(b, "A"));
        if (a.step != b.step) return keep_first(out_of_step(a, b));
        bodies.update(a, b);
        const std::optional<StateDifference> difference = compare_step(bodies.pairs(), a, b, tolerance);
        if (difference && !comparison.first) {
            comparison.first = difference;
            comparison.first->contacts_a = source_a.contacts_of(difference->body);
            comparison.first->contacts_b = source_b.contacts_of(difference->body_b);
        }
        if (!comparison.first) ++comparison.steps;
        const StepDifference largest = largest_of(bodies.pairs(), a, b);
        for (std::size_t kind = 0; kind < kKinds.size(); ++kind)
            if (largest[kind].value > comparison.largest[kind].value) comparison.largest[kind] = largest[kind];
        if (observe) observe(a.time, a.step, largest);
    }
}

// Lists the bodies of one run only, and those of other names. A body that came later in one run makes a difference in
// the step in which the other run already had it.
void sum_up(const std::vector<BodyPair>& pairs, Comparison& comparison) {
    for (const BodyPair& pair : pairs) {
        if (!pair.is_in_both()) {
            (pair.is_in(Side::a) ? comparison.removed : comparison.added)
                .push_back(pair.names[pair.is_in(Side::a) ? 0 : 1]);
            continue;
        }
        ++comparison.bodies;
        if (pair.is_renamed()) comparison.renamed.push_back({pair.names[0], pair.names[1]});
        if (!pair.late || (comparison.first && comparison.first->step <= pair.first_step)) continue;
        comparison.first = alone(pair, pair.first_step, pair.first_time, *pair.late == Side::a ? Side::b : Side::a);
        comparison.steps = pair.steps_before;
    }
}

}  // namespace

double difference_of(std::size_t component, double a, double b) {
    const bool is_angle = kKinds[kKindOf[component]].unit == "rad";
    return std::abs(is_angle ? std::remainder(a - b, 2.0 * kPi) : a - b);
}

std::uint64_t ulps_of(const StateDifference& difference) {
    if (difference.component < kPreciseComponents) return ulps_between<std::int64_t>(difference.a, difference.b);
    return ulps_between<std::int32_t>(static_cast<float>(difference.a), static_cast<float>(difference.b));
}

Comparison compare_states(StateSource& source_a, StateSource& source_b, double tolerance, const StepObserver& observe) {
    Comparison comparison;
    BodyPairs bodies;
    compare_steps(source_a, source_b, tolerance, bodies, comparison, observe);
    sum_up(bodies.pairs(), comparison);
    return comparison;
}

}  // namespace tumble::tools
