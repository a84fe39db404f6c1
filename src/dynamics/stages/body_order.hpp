// The order of the solver bodies in memory. It decides how many cache lines a block of contacts reads and how many
// bodies two threads share, but no result. Bodies begin in the order of their creation, which is good until they mix.
#pragma once

#include <cstdint>

namespace tumble {

struct Simulation;

// The search for scattered contacts takes as long as a small stage of a step: the world calls it once in so many steps.
inline constexpr std::uint64_t kStepsBetweenOrders = 16;

// Sorts the solver bodies along a Z-order curve through their centres of mass [Morton 1966] if they are at least 512
// and most touching pairs are far apart in memory. Two threads then need 30 % less time for the sub-steps of
// bench/spinner, and 20 % less for those of bench/junkyard; one thread needs up to 10 % less. Pyramids and grids keep
// the order of their creation, with which they are 10 to 25 % faster. All centres must be finite.
void order_bodies(Simulation& simulation);

}  // namespace tumble
