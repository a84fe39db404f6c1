// Pairs the bodies of two runs: by name, and bodies without a name by shape and pose.
//
// A body with a name is paired with the body of that name in the other run, in whatever step that appears. The other
// bodies are paired in the step in which they first appear: by equal shapes and an equal pose if at least one of the
// two has no name; then, if neither has a name, by equal shapes in their order, and by their index. Two bodies of
// different names are never paired.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "tools/diff/body_states.hpp"

namespace tumble::tools {

enum class Side : std::uint8_t { a, b };

// One body through both runs; [2] is by Side.
struct BodyPair {
    std::array<std::string, 2> names;                // empty: not in this run so far
    std::array<bool, 2> has_name{};                  // false: the output name is body[i]
    std::array<std::optional<std::size_t>, 2> rows;  // in the current step; nothing: not there
    std::uint64_t first_step = 0;                    // in which one of the runs has it
    double first_time = 0.0;                         // s
    std::uint64_t steps_before = 0;                  // the number of steps before that one
    std::optional<Side> late;                        // the run in which it appears later than in the other

    bool is_in(Side side) const { return !names[static_cast<std::size_t>(side)].empty(); }
    bool is_in_both() const { return is_in(Side::a) && is_in(Side::b); }
    // One run has a name for it and the other has none.
    bool is_renamed() const { return is_in_both() && names[0] != names[1] && (has_name[0] || has_name[1]); }
};

class BodyPairs {
public:
    // Finds the rows of all bodies in this step, and pairs those that appear for the first time.
    void update(const StepStates& a, const StepStates& b);

    // In the order of their first appearance.
    const std::vector<BodyPair>& pairs() const noexcept { return pairs_; }

private:
    using Rows = std::vector<std::size_t>;

    Rows find_known(Side side, const StepStates& states);
    void pair_late_names(Side side, const StepStates& states, Rows& rows);
    template <class KeyA, class KeyB>
    void pair_by(KeyA key_a, KeyB key_b, const StepStates& a, const StepStates& b, Rows& rows_a, Rows& rows_b);
    std::size_t add_pair(const StepStates& states);
    void join(std::size_t pair, Side side, const StepStates& states, std::size_t row);

    std::uint64_t steps_ = 0;  // seen so far
    std::vector<BodyPair> pairs_;
    std::array<std::unordered_map<std::string, std::size_t>, 2> by_name_;  // index into pairs_
    std::array<Rows, 2> last_;  // the pair of each row of the last step: rows seldom change their order
};

}  // namespace tumble::tools
