// Colours of contacts: no two contacts of a colour share a dynamic body, so that eight of them are solved side by side
// in lanes as if one after the other.
//
// Greedy in contact order and made afresh in every step: it costs a few nanoseconds a contact, and the order of
// solving then depends on the present contacts alone, not on how they came about.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/bodies/body_store.hpp"
#include "dynamics/bodies/constants.hpp"
#include "dynamics/contacts/contact.hpp"
#include "simd/lane_count.hpp"

namespace tumble {

class ConstraintGraph {
public:
    static constexpr std::uint32_t kNoContact = 0xffffffffu;  // a lane that is not used

    // Groups the touching contacts into blocks of kLaneCount lanes.
    void build(std::span<const Contact> contacts, const BodyStore& bodies);

    std::size_t block_count() const { return lanes_.size() / kLaneCount; }
    int color_count() const { return color_count_; }

    // The contacts of a block, by lane. Blocks are in order of solving: without a colour, between moving bodies,
    // against bodies that are not dynamic.
    std::span<const std::uint32_t, kLaneCount> block(std::size_t index) const {
        return std::span<const std::uint32_t, kLaneCount>(lanes_.data() + index * kLaneCount, kLaneCount);
    }

    std::size_t bytes() const {
        return used_colors_.capacity() * sizeof(std::uint32_t) + contact_colors_.capacity() +
               lanes_.capacity() * sizeof(std::uint32_t);
    }

private:
    static constexpr int kColors = kDynamicColors + kStaticColors;
    static constexpr std::uint8_t kNoColor = kColors;
    static constexpr std::uint8_t kNotTouching = kColors + 1;

    std::uint8_t choose_color(const Contact& contact, const BodyStore& bodies);

    std::vector<std::uint32_t> used_colors_;    // a bit a colour, by solver body
    std::vector<std::uint8_t> contact_colors_;  // by contact
    std::vector<std::uint32_t> lanes_;          // contact or kNoContact
    int color_count_ = 0;
};

}  // namespace tumble
