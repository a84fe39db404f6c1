// How far a joint is open.
#pragma once

#include "tumble/world.hpp"

namespace tumble::scene {

// The distance of the anchors where the joint holds them together, their distance across the axis of a slider or wheel,
// and how far a rod or rope is from a length that it allows (m). 0 for joints and springs that give by design, and for
// gears.
double joint_gap(const World& world, JointId id);

}  // namespace tumble::scene
