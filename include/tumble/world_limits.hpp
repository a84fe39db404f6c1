// The limits of a world that follow from its definition and the solver's constants (src/dynamics/bodies/constants.hpp,
// with their reasons): the speed of sleep, the speed limits, the softness of contacts.
#pragma once

#include "tumble/world.hpp"

namespace tumble {

struct WorldLimits {
    float rest_speed = 0.0f;         // m/s: islands faster than this stay awake
    float time_to_sleep = 0.0f;      // s: islands that are slower for this long fall asleep
    float max_speed = 0.0f;          // m/s: the speed limit of dynamic bodies
    float max_rotation = 0.0f;       // rad in a step: the rotation limit of dynamic bodies without allow_fast_rotation
    float push_out_speed = 0.0f;     // m/s: the largest speed at which overlapping shapes are pushed apart
    float contact_hertz = 0.0f;      // Hz: of the soft constraint of a contact point, on its effective mass
    float static_stiffening = 0.0f;  // the factor of that frequency in contacts with static and kinematic bodies
    float sag_part = 0.0f;           // the part of a contact's sag under a constant load that remains
    float stiffest_spring = 0.0f;    // Hz: the largest frequency of joint springs
};

// The limits of a world with this definition, which must be valid for World.
WorldLimits world_limits(const WorldDef& def);

}  // namespace tumble
