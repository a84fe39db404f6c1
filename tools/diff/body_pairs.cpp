#include "tools/diff/body_pairs.hpp"

#include <algorithm>
#include <bit>
#include <deque>
#include <map>
#include <tuple>

namespace tumble::tools {

namespace {

std::size_t index_of(Side side) { return static_cast<std::size_t>(side); }
Side other(Side side) { return side == Side::a ? Side::b : Side::a; }

// The bits of a number, equal for both zeros: a key that NaN cannot confuse.
std::uint64_t bits_of(double number) { return std::bit_cast<std::uint64_t>(number + 0.0); }

std::optional<std::string> name_key(const NamedState& body) {
    return body.has_name ? std::optional(body.body) : std::nullopt;
}

// The shapes, if both runs know them, and the pose, of a body with or without a name.
auto pose_key(bool with_shapes, bool of_named) {
    return [=](const NamedState& body) {
        const std::tuple key(with_shapes ? body.shapes : 0, bits_of(body.values[0]), bits_of(body.values[1]),
                             bits_of(body.values[2]));
        return body.has_name == of_named ? std::optional(key) : std::nullopt;
    };
}

std::optional<std::uint64_t> shape_key(const NamedState& body) {
    return body.has_name || body.shapes == 0 ? std::nullopt : std::optional(body.shapes);
}

std::optional<std::string> index_key(const NamedState& body) {
    return body.has_name ? std::nullopt : std::optional(body.body);
}

bool know_shapes(const StepStates& a, const StepStates& b) {
    const auto known = [](const NamedState& body) { return body.shapes != 0; };
    return std::ranges::all_of(a.bodies, known) && std::ranges::all_of(b.bodies, known);
}

}  // namespace

void BodyPairs::update(const StepStates& a, const StepStates& b) {
    ++steps_;
    for (BodyPair& pair : pairs_) pair.rows = {};
    Rows new_a = find_known(Side::a, a), new_b = find_known(Side::b, b);
    if (new_a.empty() && new_b.empty()) return;
    pair_by(name_key, name_key, a, b, new_a, new_b);
    pair_late_names(Side::a, a, new_a);
    pair_late_names(Side::b, b, new_b);
    const bool with_shapes = know_shapes(a, b);
    const auto unnamed = pose_key(with_shapes, false), named = pose_key(with_shapes, true);
    pair_by(unnamed, unnamed, a, b, new_a, new_b);
    pair_by(named, unnamed, a, b, new_a, new_b);
    pair_by(unnamed, named, a, b, new_a, new_b);
    pair_by(shape_key, shape_key, a, b, new_a, new_b);
    pair_by(index_key, index_key, a, b, new_a, new_b);
    for (const std::size_t row : new_a) join(add_pair(a), Side::a, a, row);
    for (const std::size_t row : new_b) join(add_pair(b), Side::b, b, row);
}

// Sets the rows of the bodies that this run had before, and returns the other rows.
BodyPairs::Rows BodyPairs::find_known(Side side, const StepStates& states) {
    const std::size_t run = index_of(side);
    Rows unknown;
    last_[run].resize(states.bodies.size(), pairs_.size());
    for (std::size_t row = 0; row < states.bodies.size(); ++row) {
        const std::string& name = states.bodies[row].body;
        std::size_t& pair = last_[run][row];
        if (pair >= pairs_.size() || pairs_[pair].names[run] != name) {
            const auto found = by_name_[run].find(name);
            pair = found == by_name_[run].end() ? pairs_.size() : found->second;
        }
        if (pair >= pairs_.size())
            unknown.push_back(row);
        else
            pairs_[pair].rows[run] = row;
    }
    return unknown;
}

// Removes from `rows` the bodies whose name only the other run has had so far, and pairs them with its bodies.
void BodyPairs::pair_late_names(Side side, const StepStates& states, Rows& rows) {
    std::erase_if(rows, [&](std::size_t row) {
        const NamedState& body = states.bodies[row];
        const auto& there = by_name_[index_of(other(side))];
        const auto found = body.has_name ? there.find(body.body) : there.end();
        if (found == there.end() || pairs_[found->second].is_in(side)) return false;
        join(found->second, side, states, row);
        pairs_[found->second].late = side;
        return true;
    });
}

// Pairs rows of equal keys in their order, and removes them from the lists.
template <class KeyA, class KeyB>
void BodyPairs::pair_by(KeyA key_a, KeyB key_b, const StepStates& a, const StepStates& b, Rows& rows_a, Rows& rows_b) {
    if (rows_a.empty() || rows_b.empty()) return;
    std::map<typename decltype(key_b(b.bodies[0]))::value_type, std::deque<std::size_t>> free;
    for (const std::size_t row : rows_b)
        if (const auto of = key_b(b.bodies[row])) free[*of].push_back(row);
    std::vector<bool> taken(b.bodies.size());
    std::erase_if(rows_a, [&](std::size_t row) {
        const auto of = key_a(a.bodies[row]);
        const auto found = of ? free.find(*of) : free.end();
        if (found == free.end() || found->second.empty()) return false;
        const std::size_t pair = add_pair(a);
        join(pair, Side::a, a, row);
        join(pair, Side::b, b, found->second.front());
        taken[found->second.front()] = true;
        found->second.pop_front();
        return true;
    });
    std::erase_if(rows_b, [&](std::size_t row) { return taken[row]; });
}

std::size_t BodyPairs::add_pair(const StepStates& states) {
    BodyPair& pair = pairs_.emplace_back();
    pair.first_step = states.step;
    pair.first_time = states.time;
    pair.steps_before = steps_ - 1;
    return pairs_.size() - 1;
}

void BodyPairs::join(std::size_t pair, Side side, const StepStates& states, std::size_t row) {
    const std::size_t run = index_of(side);
    pairs_[pair].names[run] = states.bodies[row].body;
    pairs_[pair].has_name[run] = states.bodies[row].has_name;
    pairs_[pair].rows[run] = row;
    by_name_[run].emplace(states.bodies[row].body, pair);
    last_[run][row] = pair;
}

}  // namespace tumble::tools
