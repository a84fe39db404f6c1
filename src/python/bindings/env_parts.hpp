// The parts of one step of an environment in one world.
#pragma once

#include <vector>

#include "python/bindings/env_plan.hpp"

namespace tumble::python {

// The value in [low, high] of an entry in [-1, 1].
float action_value(const ActionPlan& plan, float entry);

// Applies it for the next step.
void act(World& world, const ActionPlan& plan, float value);

// Without offset and scale; `contacts` are those of the world. Not for an expression.
double measure(const World& world, const std::vector<ContactPoint>& contacts, const ObservedPlan& plan);

void randomize(World& world, const RandomPlan& plan, float value);

// In [0, 2^53): a function of its arguments alone.
std::uint64_t random_whole(std::uint64_t seed, std::uint64_t world, std::uint64_t episode, std::uint64_t draw);

// In [0, 1): a function of its arguments alone.
double uniform(std::uint64_t seed, std::uint64_t world, std::uint64_t episode, std::uint64_t draw);

}  // namespace tumble::python
