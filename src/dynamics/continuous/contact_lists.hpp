// The contacts of each body during the impacts of a step. Impacts add and remove none.
#pragma once

#include <span>

#include "dynamics/state/simulation.hpp"

namespace tumble {

// The solid contacts of a body that have points, in the order of the store. Empty for a body that woke in this step.
// The first call after clear_contact_lists() makes the lists.
std::span<const BodyContact> contacts_of(Simulation& simulation, std::uint32_t body);

// The contact of two shapes, if it is in the list of the body; otherwise null.
Contact* find_contact(Simulation& simulation, std::uint32_t body, ProxyPair shapes);

void clear_contact_lists(Simulation& simulation);

}  // namespace tumble
