// Shapes as Box2D fixtures.
#pragma once

#include "tumble/body.hpp"
#include "tumble/shape.hpp"

class b2Body;

namespace tumble::reference {

// Adds one or more fixtures for the shape, with density 0: the mass is set for the whole body. Returns false, and adds
// nothing, for a shape that would abort the process: an outline without area or a segment without length.
bool add_fixtures(b2Body& body, const Shape& shape, const SurfaceMaterial& material);

}  // namespace tumble::reference
