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

// The least number of solver bodies that have kParts parts. To walk the empty groups of fewer bodies would be 4 % of a
// step of car_on_hills.
constexpr std::size_t kLeastInParts = 256;

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
                            std::uint32_t least_region) {
    const bool was_complete = std::exchange(is_complete_, false);
    const bool contacts_changed = update_candidates(contacts, crew), bodies_changed = update_movers(bodies);
    const bool size_changed = update(least_region_, least_region);
    if (!was_complete || contacts_changed || bodies_changed || size_changed) {
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
    std::size_t body = kStaticSolverBody + 1, color = 0;
    for (const Region& region : regions_) {
        if (region.bodies.begin != body || region.first_color != color)
            throw std::logic_error("constraint graph: a region does not begin where the last one ends");
        body = region.bodies.end;
        color = region.end_color;
    }
    if (is_complete_ && (body != movers_.size() || color != colors_.size()))
        throw std::logic_error("constraint graph: the regions do not cover all bodies and colours");
}

void ConstraintGraph::color(const BodyStore& bodies) {
    const std::size_t count = bodies.solver_bodies.size();
    const bool may_divide = count / 2 >= least_region_;
    used_colors_.assign(count, 0);
    farthest_.assign(count, 0);
    groups_.resize(solved_.size());
    part_count_ = count < kLeastInParts ? 1 : kParts;
    ends_.assign((std::size_t{kColors} + 1) * part_count_, 0);
    const std::uint64_t scale = (std::uint64_t{part_count_} << 32) / count;
    for (std::size_t i = 0; i < solved_.size(); ++i) {
        const Candidate& contact = candidates_[solved_[i]];
        const std::uint32_t color = choose_color(contact, bodies);
        // Contacts without a colour stay in their order: they depend on each other.
        const std::uint64_t part = color == kNoColor ? 0 : dynamic_body(contact, bodies) * scale >> 32;
        groups_[i] = color * part_count_ + static_cast<std::uint32_t>(part);
        TUMBLE_CHECK(groups_[i] < ends_.size());
        ++ends_[groups_[i]];
        if (may_divide) connect(contact, bodies);
    }
    find_regions(farthest_, least_region_, bounds_);
    if (bounds_.size() > 2) group_by_region(bodies);
}

// The parts are the regions.
void ConstraintGraph::group_by_region(const BodyStore& bodies) {
    region_of_.resize(farthest_.size());
    for (std::uint32_t region = 0; region + 1 < bounds_.size(); ++region)
        std::fill(region_of_.begin() + bounds_[region], region_of_.begin() + bounds_[region + 1], region);
    const std::uint32_t old_count = std::exchange(part_count_, static_cast<std::uint32_t>(bounds_.size() - 1));
    ends_.assign((std::size_t{kColors} + 1) * part_count_, 0);
    for (std::size_t i = 0; i < solved_.size(); ++i) {
        const std::uint32_t color = groups_[i] / old_count;
        groups_[i] = color * part_count_ + region_of_[dynamic_body(candidates_[solved_[i]], bodies)];
        ++ends_[groups_[i]];
    }
}

void ConstraintGraph::fill_lanes() {
    lanes_.clear();
    colors_.clear();
    regions_.clear();
    for (std::uint32_t i = 0; i + 1 < bounds_.size(); ++i) add_region(i);
    for (std::size_t i = 0; i < solved_.size(); ++i) {
        std::uint32_t& next = ends_[groups_[i]];
        TUMBLE_CHECK(next < lanes_.size());
        lanes_[next] = solved_[i];
        next += groups_[i] >= kNoColor * part_count_ ? kLaneCount : 1;
    }
}

// Adds a region with its colours and empty lanes, and notes in ends_ where the lanes of its groups begin.
void ConstraintGraph::add_region(std::uint32_t index) {
    Region region{{bounds_[index], bounds_[index + 1]}, colors_.size()};
    const auto first_lane = static_cast<std::uint32_t>(lanes_.size());
    const std::uint32_t parts = part_count_ / static_cast<std::uint32_t>(bounds_.size() - 1);
    std::uint32_t end = first_lane;
    // Contacts without a colour come first, with a block for each.
    for (std::uint32_t i = 0; i <= kColors; ++i) {
        const std::uint32_t color = i == 0 ? kNoColor : i - 1, begin = end;
        const std::uint32_t lanes_of_contact = color == kNoColor ? kLaneCount : 1;
        for (std::uint32_t part = index * parts; part < (index + 1) * parts; ++part)
            end += lanes_of_contact * std::exchange(ends_[color * part_count_ + part], end);
        if (end == begin) continue;
        end = (end + kLaneCount - 1) / kLaneCount * kLaneCount;
        colors_.push_back({begin / kLaneCount, end / kLaneCount, color != kNoColor});
    }
    lanes_.resize(end, kNoContact);
    region.end_color = colors_.size();
    constexpr std::size_t kWorkOfContact = 4;  // in bodies
    region.work = region.bodies.end - region.bodies.begin + kWorkOfContact * (end - first_lane);
    regions_.push_back(region);
}

int ConstraintGraph::color_count() const {
    std::uint32_t used = 0;
    for (const std::uint32_t colors : used_colors_) used |= colors;
    return std::popcount(used & (kDynamicMask | kStaticMask));
}

bool ConstraintGraph::has_even_regions(std::size_t threads) const {
    std::size_t most = 0, all = 0;
    for (const Region& region : regions_) {
        most = std::max(most, region.work);
        all += region.work;
    }
    return 2 * threads * most <= 3 * all;
}

}  // namespace tumble
