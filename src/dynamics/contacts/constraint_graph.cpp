#include "dynamics/contacts/constraint_graph.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include "debug/check.hpp"

namespace tumble {

namespace {

constexpr std::uint32_t kDynamicMask = (1u << kDynamicColors) - 1u;
constexpr std::uint32_t kStaticMask = ((1u << kStaticColors) - 1u) << kDynamicColors;

// Sets a value. Returns true if it changed.
template <class T>
bool update(T& value, const T& now) {
    const bool changes = value != now;
    value = now;
    return changes;
}

}  // namespace

bool ConstraintGraph::update_candidates(std::span<const Contact> contacts, Crew& crew) {
    constexpr std::size_t kLeastUpdated = 1024;  // in a chunk: about 3 us of work
    std::atomic<bool> has_changed = candidates_.size() != contacts.size();
    candidates_.resize(contacts.size());
    crew.for_each_chunk(contacts.size(), kLeastUpdated, [&](const Chunk& chunk) {
        bool changes = false;
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
            const Contact& contact = contacts[i];
            prefetch_after(contacts, i, 1);
            const bool is_solved = contact.manifold.point_count > 0 && !contact.is_bouncing;
            const std::uint32_t skips = is_solved ? contact.skipped_colors : Candidate::kNotSolved;
            changes |= update(candidates_[i], {contact.body_a, contact.body_b, skips});
        }
        if (changes) has_changed.store(true, std::memory_order_relaxed);
    });
    return has_changed;
}

bool ConstraintGraph::update_movers(const BodyStore& bodies) {
    bool changes = movers_.size() != bodies.moving.size();
    movers_.resize(bodies.moving.size());
    for (std::size_t i = 0; i < movers_.size(); ++i) {
        const bool is_dynamic = bodies.solver_bodies[i].flags & kDynamicBody;
        changes |= update(movers_[i], {bodies.moving[i].body, is_dynamic});
    }
    return changes;
}

// Branch-free: the processor cannot predict which contacts are solved.
void ConstraintGraph::find_solved() {
    solved_.resize(candidates_.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
        solved_[count] = static_cast<std::uint32_t>(i);
        count += candidates_[i].is_solved();
    }
    solved_.resize(count);
}

// The lowest colour that neither dynamic body has, after those that the contact skips. Static and kinematic bodies may
// have several contacts of a colour.
std::uint8_t ConstraintGraph::choose_color(const Candidate& contact, const BodyStore& bodies) {
    const bool dynamic_a = bodies.is_dynamic(contact.body_a), dynamic_b = bodies.is_dynamic(contact.body_b);
    TUMBLE_CHECK((dynamic_a || dynamic_b));
    TUMBLE_CHECK((!dynamic_a || bodies.frames[contact.body_a].solver_body != kStaticSolverBody));
    TUMBLE_CHECK((!dynamic_b || bodies.frames[contact.body_b].solver_body != kStaticSolverBody));
    std::uint32_t* const used_a = &used_colors_[bodies.frames[contact.body_a].solver_body];
    std::uint32_t* const used_b = &used_colors_[bodies.frames[contact.body_b].solver_body];
    std::uint32_t free = dynamic_a && dynamic_b ? kDynamicMask : kStaticMask;
    if (dynamic_a) free &= ~*used_a;
    if (dynamic_b) free &= ~*used_b;
    for (unsigned i = 0; i < contact.skipped_colors && !std::has_single_bit(free) && free != 0; ++i) free &= free - 1;
    const int color = free == 0 ? kNoColor : std::countr_zero(free);
    TUMBLE_CHECK(color <= kColors);
    if (dynamic_a) *used_a |= 1u << color;
    if (dynamic_b) *used_b |= 1u << color;
    return static_cast<std::uint8_t>(color);
}

void ConstraintGraph::build(std::span<const Contact> contacts, const BodyStore& bodies, Crew& crew) {
    const bool was_complete = std::exchange(is_complete_, false);
    const bool contacts_changed = update_candidates(contacts, crew), bodies_changed = update_movers(bodies);
    if (!was_complete || contacts_changed || bodies_changed) {
        find_solved();
        color(bodies);
    }
    is_complete_ = true;
}

void ConstraintGraph::audit() const {
    std::vector<std::uint32_t> listed;
    std::copy_if(lanes_.begin(), lanes_.end(), std::back_inserter(listed),
                 [](std::uint32_t contact) { return contact != kNoContact; });
    std::sort(listed.begin(), listed.end());
    if (is_complete_ && listed != solved_)
        throw std::logic_error("constraint graph: " + std::to_string(listed.size()) + " lanes for " +
                               std::to_string(solved_.size()) + " contacts");
}

void ConstraintGraph::color(const BodyStore& bodies) {
    std::array<std::uint32_t, kNoGroup + 1> count{};  // contacts by group
    used_colors_.assign(bodies.solver_bodies.size(), 0);
    groups_.resize(solved_.size());
    const std::uint64_t scale = (std::uint64_t{kParts} << 32) / bodies.solver_bodies.size();
    for (std::size_t i = 0; i < solved_.size(); ++i) {
        const Candidate& contact = candidates_[solved_[i]];
        const std::uint32_t color = choose_color(contact, bodies);
        const std::uint32_t body = bodies.is_dynamic(contact.body_a) ? contact.body_a : contact.body_b;
        const std::uint32_t part = static_cast<std::uint32_t>(bodies.frames[body].solver_body * scale >> 32);
        TUMBLE_CHECK(part < kParts);
        groups_[i] = static_cast<std::uint16_t>(color == kNoColor ? kNoGroup : color * kParts + part);
        ++count[groups_[i]];
    }
    fill_lanes(count);
}

void ConstraintGraph::fill_lanes(std::span<const std::uint32_t, kNoGroup + 1> count) {
    std::array<std::uint32_t, kNoGroup + 1> next{};  // the first lane of each group
    color_count_ = 0;
    colors_.clear();
    lanes_.clear();
    // Contacts without a colour come first, with a block for each.
    std::uint32_t end = count[kNoGroup] * kLaneCount;
    if (end > 0) colors_.push_back({0, end / kLaneCount, false});
    for (std::size_t color = 0; color < kColors; ++color) {
        const std::uint32_t begin = end;
        for (std::size_t group = color * kParts; group < (color + 1) * kParts; ++group) {
            next[group] = end;
            end += count[group];
        }
        if (end == begin) continue;
        end = (end + kLaneCount - 1) / kLaneCount * kLaneCount;
        colors_.push_back({begin / kLaneCount, end / kLaneCount});
        ++color_count_;
    }
    lanes_.assign(end, kNoContact);
    for (std::size_t i = 0; i < solved_.size(); ++i) {
        const std::uint16_t group = groups_[i];
        TUMBLE_CHECK(next[group] < end);
        lanes_[next[group]] = solved_[i];
        next[group] += group == kNoGroup ? kLaneCount : 1;
    }
}

}  // namespace tumble
