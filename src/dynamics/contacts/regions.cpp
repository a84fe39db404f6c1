#include "dynamics/contacts/regions.hpp"

#include <algorithm>

#include "debug/check.hpp"

namespace tumble {

void find_regions(std::span<const std::uint32_t> farthest, const RegionRule& rule,
                  std::vector<std::uint32_t>& first_bodies) {
    TUMBLE_CHECK(rule.least_bodies > 0);
    first_bodies.assign(1, 0);
    std::uint32_t end = 0;  // no contact connects a body before this one with a later one, except as found
    for (std::uint32_t i = 0; i < farthest.size(); ++i) {
        if (i > end && i - first_bodies.back() >= rule.least_bodies && farthest.size() - i >= rule.least_bodies)
            first_bodies.push_back(i);
        end = std::max({end, i, farthest[i]});
    }
    if (first_bodies.size() < rule.least_regions) first_bodies.resize(1);
}

}  // namespace tumble
