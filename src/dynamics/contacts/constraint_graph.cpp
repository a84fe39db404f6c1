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

// A dynamic body of the contact: its solver body.
std::uint32_t ConstraintGraph::dynamic_body(const Candidate& contact, const BodyStore& bodies) {
    return bodies.frames[bodies.is_dynamic(contact.body_a) ? contact.body_a : contact.body_b].solver_body;
}

// Notes for the lower of two bodies that may move that a contact connects it with the higher one.
void ConstraintGraph::connect(const Candidate& contact, const BodyStore& bodies) {
    const std::uint32_t a = bodies.frames[contact.body_a].solver_body, b = bodies.frames[contact.body_b].solver_body;
    const std::uint32_t lower = std::min(a, b);
    if (lower != kStaticSolverBody) farthest_[lower] = std::max({farthest_[lower], a, b});
}

void ConstraintGraph::build(std::span<const Contact> contacts, const BodyStore& bodies, Crew& crew,
                            const RegionRule& rule) {
    const bool was_complete = std::exchange(is_complete_, false);
    const bool contacts_changed = update_candidates(contacts, crew), bodies_changed = update_movers(bodies);
    const bool rule_changed = update(rule_, rule);
    if (!was_complete || contacts_changed || bodies_changed || rule_changed) {
        find_solved();
        color(bodies);
        fill_lanes();
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
    const std::size_t count = bodies.solver_bodies.size();
    const bool may_divide = rule_.least_bodies < count;
    used_colors_.assign(count, 0);
    farthest_.assign(may_divide ? count : 0, 0);
    groups_.resize(solved_.size());
    part_count_ = kParts;
    ends_.assign((kColors + 1) * kParts, 0);
    const std::uint64_t scale = (std::uint64_t{kParts} << 32) / count;
    for (std::size_t i = 0; i < solved_.size(); ++i) {
        const Candidate& contact = candidates_[solved_[i]];
        const std::uint32_t color = choose_color(contact, bodies);
        groups_[i] = color * kParts + static_cast<std::uint32_t>(dynamic_body(contact, bodies) * scale >> 32);
        TUMBLE_CHECK(groups_[i] < ends_.size());
        ++ends_[groups_[i]];
        if (may_divide) connect(contact, bodies);
    }
    first_bodies_.assign(1, 0);
    if (may_divide) find_regions(farthest_, rule_, first_bodies_);
    if (first_bodies_.size() > 1) group_by_region(bodies);
}

// The parts are the regions.
void ConstraintGraph::group_by_region(const BodyStore& bodies) {
    std::vector<std::uint32_t>& region_of = farthest_;
    for (std::size_t i = 0; i < first_bodies_.size(); ++i) {
        const std::size_t end = i + 1 < first_bodies_.size() ? first_bodies_[i + 1] : region_of.size();
        std::fill(region_of.begin() + first_bodies_[i], region_of.begin() + static_cast<std::ptrdiff_t>(end),
                  static_cast<std::uint32_t>(i));
    }
    part_count_ = static_cast<std::uint32_t>(first_bodies_.size());
    ends_.assign((kColors + 1) * part_count_, 0);
    for (std::size_t i = 0; i < solved_.size(); ++i) {
        const std::uint32_t color = groups_[i] / kParts;
        groups_[i] = color * part_count_ + region_of[dynamic_body(candidates_[solved_[i]], bodies)];
        ++ends_[groups_[i]];
    }
}

void ConstraintGraph::fill_lanes() {
    colors_.clear();
    std::uint32_t end = 0, used_colors = 0;
    const std::size_t region_count = first_bodies_.size();
    const std::size_t parts_of_region = part_count_ / region_count;
    regions_.resize(region_count);
    for (std::size_t region = 0; region < region_count; ++region) {
        const std::size_t end_body = region + 1 < region_count ? first_bodies_[region + 1] : used_colors_.size();
        const std::size_t first_color = colors_.size();
        // Contacts without a colour come first, with a block for each.
        for (std::uint32_t i = 0; i <= kColors; ++i) {
            const std::uint32_t color = i == 0 ? kNoColor : i - 1, begin = end;
            const std::uint32_t lanes = color == kNoColor ? kLaneCount : 1;
            for (std::size_t part = 0; part < parts_of_region; ++part) {
                std::uint32_t& of_group = ends_[color * part_count_ + region * parts_of_region + part];
                end += lanes * std::exchange(of_group, end);
            }
            if (end == begin) continue;
            end = (end + kLaneCount - 1) / kLaneCount * kLaneCount;
            colors_.push_back({begin / kLaneCount, end / kLaneCount, color != kNoColor});
            if (color != kNoColor) used_colors |= 1u << color;
        }
        regions_[region] = {first_bodies_[region], end_body, first_color, colors_.size()};
    }
    color_count_ = std::popcount(used_colors);
    lanes_.assign(end, kNoContact);
    for (std::size_t i = 0; i < solved_.size(); ++i) {
        std::uint32_t& next = ends_[groups_[i]];
        TUMBLE_CHECK(next < end);
        lanes_[next] = solved_[i];
        next += groups_[i] >= kNoColor * part_count_ ? kLaneCount : 1;
    }
}

}  // namespace tumble
