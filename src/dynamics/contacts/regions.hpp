// Regions: ranges of the solver bodies that no contact connects. The solver runs all sub-steps of a region before it
// goes on to the next one, so that a core's cache keeps the region; threads solve regions at the same time. As regions
// share no body that moves, the result does not depend on them.
//
// A step of bench/many_pyramids, whose piles were built one after the other, takes 83 % of the time on one thread, and
// 80 % on two.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

// When the bodies are divided into regions. By default, never.
struct RegionRule {
    std::size_t least_bodies = static_cast<std::size_t>(-1);  // in a region
    std::size_t least_regions = 2;                            // otherwise there is one region

    friend bool operator==(const RegionRule&, const RegionRule&) = default;
};

// Finds the first solver body of each region. `farthest` has, for each solver body, the largest index of a solver body
// that a contact connects with it, or anything less than its own index.
void find_regions(std::span<const std::uint32_t> farthest, const RegionRule& rule,
                  std::vector<std::uint32_t>& first_bodies);

}  // namespace tumble
