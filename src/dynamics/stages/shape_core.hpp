// Smaller shapes inside a shape, with which continuous collision decides.
#pragma once

#include "dynamics/bodies/shape_store.hpp"

namespace tumble {

// The shape shrunk about its middle to a part of its thickness, and by the same length along its long axis: the tip of
// a bar sinks in as far as its side. The part 0 is the middle point. The part 1 is the shape: a shape so large that
// floats round what is to be cut off to nothing.
Shape core_of(const ShapeRecord& record, float part);

}  // namespace tumble
