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

// Both list their bodies in the order of their ids.
std::optional<StateDifference> compare_step(const StepStates& a, const StepStates& b, double tolerance) {
    StateDifference first;
    first.step = a.step;
    first.time = a.time;
    if (a.step != b.step) {
        first.what = "A continues with step " + std::to_string(a.step) + ", B with step " + std::to_string(b.step);
        return first;
    }
    for (std::size_t i = 0; i < std::max(a.bodies.size(), b.bodies.size()); ++i) {
        const bool in_both = i < a.bodies.size() && i < b.bodies.size() && a.bodies[i].body == b.bodies[i].body;
        if (!in_both) {
            if (first.differing_bodies > 0) break;
            first.body = i < a.bodies.size() ? a.bodies[i].body : b.bodies[i].body;
            first.what = std::string("the body is in ") + (i < a.bodies.size() ? "A" : "B") +
                         " only, or the bodies are in another order";
            return first;
        }
        const std::optional<std::size_t> component = first_differing(a.bodies[i], b.bodies[i], tolerance);
        if (!component) continue;
        if (first.differing_bodies++ > 0) continue;
        first.body = a.bodies[i].body;
        first.component = *component;
        first.a = a.bodies[i].values[*component];
        first.b = b.bodies[i].values[*component];
    }
    if (first.differing_bodies == 0) return std::nullopt;
    return first;
}

StateDifference ends_early(const StepStates& longer, const char* shorter) {
    StateDifference difference;
    difference.step = longer.step;
    difference.time = longer.time;
    difference.what = std::string(shorter) + " ends before this step";
    return difference;
}

void update_largest(std::array<LargestDifference, kKinds.size()>& largest, const StepStates& a, const StepStates& b) {
    for (std::size_t i = 0; i < std::min(a.bodies.size(), b.bodies.size()); ++i)
        for (std::size_t component = 0; component < kComponents.size(); ++component) {
            const double value = difference_of(component, a.bodies[i].values[component], b.bodies[i].values[component]);
            LargestDifference& so_far = largest[kKindOf[component]];
            if (value > so_far.value) so_far = {value, a.bodies[i].body, a.step};
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

Comparison compare_states(StateSource& source_a, StateSource& source_b, double tolerance) {
    Comparison comparison;
    StepStates a, b;
    for (;;) {
        const bool more_a = source_a.next(a), more_b = source_b.next(b);
        if (!more_a && !more_b) return comparison;
        if (more_a != more_b) {
            if (!comparison.first) comparison.first = more_a ? ends_early(a, "B") : ends_early(b, "A");
            return comparison;
        }
        comparison.bodies = std::max(comparison.bodies, a.bodies.size());
        const std::optional<StateDifference> difference = compare_step(a, b, tolerance);
        if (!difference && !comparison.first) ++comparison.steps;
        if (difference && !comparison.first) {
            comparison.first = difference;
            comparison.first->contacts_a = source_a.contacts_of(difference->body);
            comparison.first->contacts_b = source_b.contacts_of(difference->body);
        }
        if (difference && !difference->what.empty()) return comparison;
        update_largest(comparison.largest, a, b);
    }
}

}  // namespace tumble::tools
