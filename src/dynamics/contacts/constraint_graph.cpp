#include "dynamics/contacts/constraint_graph.hpp"

#include <array>
#include <bit>

#include "debug/check.hpp"

namespace tumble {

namespace {

constexpr std::uint32_t kDynamicMask = (1u << kDynamicColors) - 1u;
constexpr std::uint32_t kStaticMask = ((1u << kStaticColors) - 1u) << kDynamicColors;

}  // namespace

// The lowest colour that neither dynamic body has, after those that the contact skips. Static and kinematic bodies may
// have several contacts of a colour.
std::uint8_t ConstraintGraph::choose_color(const Contact& contact, const BodyStore& bodies) {
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

void ConstraintGraph::build(std::span<const Contact> contacts, const BodyStore& bodies) {
    used_colors_.assign(bodies.solver_bodies.size(), 0);
    contact_colors_.resize(contacts.size());
    std::array<std::uint32_t, kColors + 1> count{};  // contacts by colour; the last: without a colour
    bool has_touching = false;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        prefetch_after(contacts, i, 1);
        const bool touching = contacts[i].manifold.point_count > 0 && !contacts[i].is_bouncing;
        contact_colors_[i] = touching ? choose_color(contacts[i], bodies) : kNotTouching;
        if (touching) ++count[contact_colors_[i]];
        has_touching |= touching;
    }
    color_count_ = 0;
    colors_.clear();
    lanes_.clear();
    if (!has_touching) return;

    // The first lane of each colour. Contacts without a colour come first, with a block for each.
    std::array<std::uint32_t, kColors> next{};
    std::uint32_t end = count[kNoColor] * kLaneCount;
    if (end > 0) colors_.push_back({0, end / kLaneCount, false});
    for (std::size_t color = 0; color < kColors; ++color) {
        next[color] = end;
        end += (count[color] + kLaneCount - 1) / kLaneCount * kLaneCount;
        color_count_ += count[color] > 0;
        if (count[color] > 0) colors_.push_back({next[color] / kLaneCount, end / kLaneCount});
    }
    TUMBLE_CHECK(end % kLaneCount == 0u);
    lanes_.assign(end, kNoContact);
    std::uint32_t next_alone = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const std::uint8_t color = contact_colors_[i];
        if (color == kNotTouching) continue;
        if (color == kNoColor) {
            TUMBLE_CHECK(next_alone < count[kNoColor] * kLaneCount);
            lanes_[next_alone] = static_cast<std::uint32_t>(i);
            next_alone += kLaneCount;
        } else {
            TUMBLE_CHECK(next[color] < end);
            lanes_[next[color]++] = static_cast<std::uint32_t>(i);
        }
    }
}

}  // namespace tumble
