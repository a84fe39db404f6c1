// Shapes as Box2D fixtures.
#pragma once

#include "tumble/body.hpp"
#include "tumble/shape.hpp"

class b2Body;

namespace tumble::reference {

// Adds the fixture or fixtures that stand for the shape; their density is 0, as the body's mass is set for all of it.
// False if Box2D would stop the process at it: an outline without area or a segment without length.
bool add_fixtures(b2Body& body, const Shape& shape, const SurfaceMaterial& material);

}  // namespace tumble::reference
