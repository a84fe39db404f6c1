// Ids of the bodies, shapes and joints of a world: an index and a generation. Ids of destroyed objects are recognised,
// as their index gets another generation.
#pragma once

#include <compare>
#include <cstdint>

namespace tumble {

// A default id is not valid in any world. Ids are ordered by index, the order in which a world lists and steps objects.
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
