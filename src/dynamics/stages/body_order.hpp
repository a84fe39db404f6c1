// The order of the solver bodies in memory. It decides how many cache lines a block of contacts reads, and how many
// bodies two threads share. Bodies begin in the order of their creation, which is good until they mix.
//
// Results depend on the order only where terms are summed by solver body: by rounding in the direct solver of joints,
// and where two bodies meet a third at exactly the same time. They are the same on any number of threads.
#pragma once

#include <cstdint>

namespace tumble {

struct Simulation;

// The search for scattered bodies takes as long as a small stage of a step: it runs once in so many steps.
inline constexpr std::uint64_t kStepsBetweenOrders = 16;

// A stage of the step: sorts the solver bodies along a Morton curve through their centres of mass [Morton 1966] if they
// are scattered: if most pairs of dynamic bodies that touch are far apart in memory, and the curve halves the number of
// these. Allocates if they are scattered. Two threads then need 30 % less time for the sub-steps of bench/spinner, and
// 20 % less for those of bench/junkyard; one thread needs up to 10 % less. Pyramids and grids keep the order of their
// creation, with which they are 10 to 25 % faster.
void order_bodies(Simulation& simulation);

}  // namespace tumble
