// Regions: ranges of the solver bodies that no contact connects with the others. The solver runs all sub-steps of a
// region before it goes on to the next one, so that a core's cache keeps the region; threads solve regions at the same
// time. Regions share no body that moves: they give the same result in any order. They depend on the contacts alone,
// not on the number of threads.
//
// A step of bench/many_pyramids, whose piles were built one after the other, takes 83 % of the time on one thread, and
// 80 % on two.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

// The number of bodies of a region, at least. Contacts, blocks and bodies of a thousand boxes fill half of a cache of
// 2 MB.
inline constexpr std::uint32_t kLeastRegion = 1000;
inline constexpr std::uint32_t kOneRegion = 0xffffffffu;

// Finds the first solver body of each region, and the end of the last one. The first one begins after the static solver
// body. `farthest` has, for each solver body, the largest index of a solver body that a contact connects with it, or
// anything less than its own index.
void find_regions(std::span<const std::uint32_t> farthest, std::uint32_t least_bodies,
                  std::vector<std::uint32_t>& bounds);

}  // namespace tumble
