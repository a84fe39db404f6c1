// Compares the states of two runs step by step: which bodies only one of them has, where the bodies of both first
// differ, and how far they differ at most.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/diff/body_pairs.hpp"
#include "tools/diff/body_states.hpp"

namespace tumble::tools {

// The kinds of components: one tolerance applies to each in its own unit.
struct ComponentKind {
    std::string_view name, unit;
};
inline constexpr std::array<ComponentKind, 4> kKinds{
    {{"position", "m"}, {"angle", "rad"}, {"velocity", "m/s"}, {"angular velocity", "rad/s"}}};

// Index into kKinds, by component.
inline constexpr std::array<std::size_t, kComponents.size()> kKindOf{0, 0, 1, 2, 2, 3};

// The first difference of the bodies that both runs have.
struct StateDifference {
    std::uint64_t step = 0;
    double time = 0.0;  // s
    std::string what;   // of a difference other than of numbers: "B ends before this step"; else empty
    std::string body;   // its name in A
    std::string body_b;
    std::size_t component = 0;                        // index into kComponents
    double a = 0.0, b = 0.0;                          // the values of the component
    std::size_t differing_bodies = 0;                 // in this step
    std::vector<std::string> contacts_a, contacts_b;  // of the body
};

// The largest difference in one kind of component.
struct LargestDifference {
    double value = 0.0;
    std::string body;
    std::uint64_t step = 0;
};

// A body that has a name in one run only. The other run counts it, as body[3].
struct RenamedBody {
    std::string a, b;
};

// The largest differences of one step, by kind.
using StepDifference = std::array<LargestDifference, kKinds.size()>;

// Gets each step that both runs have, with its largest differences; the sources have the states of the step.
using StepObserver = std::function<void(double time, std::uint64_t step, const StepDifference& largest)>;

struct Comparison {
    std::uint64_t steps = 0;           // equal steps before the first difference
    std::size_t bodies = 0;            // that both runs have
    std::vector<std::string> added;    // bodies that only B has
    std::vector<std::string> removed;  // bodies that only A has
    std::vector<RenamedBody> renamed;
    std::optional<StateDifference> first;
    StepDifference largest;  // by kind, over all steps

    bool is_equal() const { return !first && added.empty() && removed.empty() && renamed.empty(); }
};

// Components differ if they are farther apart than the tolerance (m, rad, m/s, rad/s); NaN equals NaN only. Throws as
// StateSource::next().
Comparison compare_states(StateSource& source_a, StateSource& source_b, double tolerance,
                          const StepObserver& observe = {});

// The distance of two values of a component; of angles, along the shorter arc.
double difference_of(std::size_t component, double a, double b);

// The distance of the two values of a difference in floating-point numbers of the component's type.
std::uint64_t ulps_of(const StateDifference& difference);

}  // namespace tumble::tools
