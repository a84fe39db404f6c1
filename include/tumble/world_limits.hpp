// What the stepper's constants come to in a world: when its bodies rest, how soft its contacts are, what it cuts off.
// For claims and warnings about worlds; the constants and their reasons are in src/dynamics/constants.hpp.
#pragma once

#include "tumble/world.hpp"

namespace tumble {

struct WorldLimits {
    float rest_speed = 0.0f;         // m/s: what is slower for long enough falls asleep
    float max_speed = 0.0f;          // m/s: no dynamic body moves faster
    float most_turn = 0.0f;          // rad in a step: no dynamic body turns farther, unless it may turn fast
    float push_out_speed = 0.0f;     // m/s: the fastest that overlap is pushed out
    float contact_hertz = 0.0f;      // of the spring of a contact point, on the mass that it moves
    float static_stiffening = 0.0f;  // times that frequency, against what is not dynamic
    float sag_part = 0.0f;           // of what that spring would give way under a load that stays
    float stiffest_spring = 0.0f;    // Hz: springs of joints are no stiffer, whatever they ask for
};

// Of a world of this definition, as World makes it.
WorldLimits world_limits(const WorldDef& def);

}  // namespace tumble
