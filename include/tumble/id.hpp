// Ids of what a world holds: an index and a generation, so that an id of something destroyed is recognised as stale.
#pragma once

#include <compare>
#include <cstdint>

namespace tumble {

// The default id names nothing. Ids order by index: the order in which a world lists and steps its things.
template <class Tag>
struct Id {
    std::uint32_t index = 0xffffffffu;
    std::uint32_t generation = 0;

    friend constexpr auto operator<=>(Id, Id) = default;
};

using BodyId = Id<struct BodyTag>;
using ShapeId = Id<struct ShapeTag>;
using JointId = Id<struct JointTag>;

}  // namespace tumble
