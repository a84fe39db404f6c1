// Boxes that fall asleep and wake together, for tests.
#pragma once

#include <algorithm>
#include <vector>

#include "support/worlds.hpp"

namespace tumble::test {

inline const Shape kBox = make_box({1.0f, 1.0f});

// Boxes of 1 m on top of each other, on the ground at y = 0.
inline std::vector<BodyId> add_stack(World& world, int count) {
    std::vector<BodyId> boxes;
    for (int i = 0; i < count; ++i) boxes.push_back(add_dynamic(world, {0.0, 0.5 + i}, kBox));
    return boxes;
}

inline bool all_asleep(const World& world, const std::vector<BodyId>& bodies) {
    return std::ranges::none_of(bodies, [&](BodyId body) { return world.is_awake(body); });
}
inline bool all_awake(const World& world, const std::vector<BodyId>& bodies) {
    return std::ranges::all_of(bodies, [&](BodyId body) { return world.is_awake(body); });
}

}  // namespace tumble::test
