// The last bound of motion: static and kinematic shapes.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// A stage of the step, before poses are final. The solver and the impacts keep bodies apart; where neither has done so
// in its bounded work, a body stops where its core touches the immovable shape. It loses its velocity into that shape,
// unless the two have restitution: then they bounce in the next step. The body turns on if only its middle touches and
// its rotation leaves that point where it is. The core is half as thick as the shape, or less if that half overlaps
// already. A shape whose middle is inside when the step begins is left to the solver. Of a body with impacts, the chord
// to the last of them is bounded, and the motion after it.
//
// The thickness is the smaller side of the shape's box in body coordinates: a thin shape that is turned within its body
// is bounded too late.
void keep_out_of_immovable(Simulation& simulation);

}  // namespace tumble
