// The core of a shape: a smaller shape inside it. Continuous collision stops a body only if its core would touch.
#pragma once

#include "dynamics/bodies/shape_store.hpp"

namespace tumble {

// The shape shrunk about its middle to `part` of its thickness, from 0 to 1. Its length shrinks by the same number of
// metres as its thickness, so that the tip of a bar may sink in as far as its side. With part = 0 the core is the
// middle point. With part = 1 it is the shape itself, as for a shape so large that floats cannot hold the difference.
Shape core_of(const ShapeRecord& record, float part);

}  // namespace tumble
