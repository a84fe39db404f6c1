// The definition of a world, and the limits that follow from it.
#pragma once

#include <cstdint>

#include "tumble/joint.hpp"
#include "tumble/math.hpp"
#include "tumble/threads.hpp"

namespace tumble {

// When impacts happen within a step.
enum class ImpactModel : std::uint8_t {
    // A body bounces at the end of the step in which it lands. A fast body stops at its first impact with a static or
    // kinematic body, and goes on in the next step. Only bullets are swept against dynamic bodies.
    at_step_end,

    // Each impact happens at its time, with its bounce and its friction, and the bodies go on from there. Impacts at
    // one time are solved together, through rows of touching bodies [Smith, Kaufman, Vouga, Tamstorf, Grinspun 2012,
    // "Reflections on simultaneous impact"]. Fast bodies collide with all others, as bullets do. Shapes that will touch
    // within a step become contacts when it starts, so that they do not overlap. Friction is bounded by the impulse
    // that stops the bodies, without the part that pushes overlap out. A body that nothing touches follows its exact
    // parabola. A contact bounces if it leaves with more than twice the speed that gravity adds in a step. Of bodies
    // that land while they carry others, the fastest have impacts, and the contact solver stops the rest.
    //
    // Joints do not take part in impacts: a joined body that is struck goes on in the next step. A step takes longer
    // than with at_step_end: by a tenth for a pile at rest, by half where hundreds of bodies collide at once, twice as
    // long where hundreds bounce, and three to six times as long where thousands are struck (the scenes bench/spinner,
    // tumbler and smash). The default.
    in_order,
};

struct WorldDef {
    Vec2 gravity{0.0f, -10.0f};      // m/s^2
    float steps_per_second = 60.0f;  // > 0
    int substeps = 4;                // in each step, >= 1; more make joints and stacks stiffer
    bool sleeping = true;            // islands at rest fall asleep
    bool continuous = true;          // continuous collision keeps fast bodies from passing through thin ones
    JointSolver joints = JointSolver::iterative;
    ImpactModel impacts = ImpactModel::in_order;

    // The size of a typical body, m, > 0. The solver's own constants are for bodies of 1 m. For a scale s its lengths
    // are multiplied by s, its speeds by sqrt(s) and its frequencies by 1 / sqrt(s), as under equal gravity. A world of
    // marbles (0.02) then behaves like one of boulders, if it also makes 1 / sqrt(s) times the steps per second.
    float scale = 1.0f;

    Threads threads{};  // that make a step; not saved in snapshots
};

// Limits that follow from the definition and the constants of the solver (src/dynamics/bodies/constants.hpp, with their
// reasons): the speed of sleep, the speed limits, the softness of contacts.
struct WorldLimits {
    float rest_speed = 0.0f;         // m/s: islands faster than this stay awake
    float time_to_sleep = 0.0f;      // s: islands that are slower for this long fall asleep
    float max_speed = 0.0f;          // m/s: the speed limit of dynamic bodies
    float max_rotation = 0.0f;       // rad in a step: the rotation limit of dynamic bodies without allow_fast_rotation
    float push_out_speed = 0.0f;     // m/s: the largest speed at which overlapping shapes are pushed apart
    float contact_hertz = 0.0f;      // Hz: of the soft constraint of a contact point, on its effective mass
    float static_stiffening = 0.0f;  // the factor of that frequency in contacts with static and kinematic bodies
    float stiffest_spring = 0.0f;    // Hz: the largest frequency of joint springs
};

// The limits of a world with this definition, which must be valid for World.
WorldLimits world_limits(const WorldDef& def);

}  // namespace tumble
