// When impacts happen within a step.
#pragma once

#include <cstdint>

namespace tumble {

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
    // than with at_step_end: a tenth for a pile at rest, half where hundreds of bodies collide at once, and twice as
    // long where hundreds bounce. The default.
    in_order,
};

}  // namespace tumble
