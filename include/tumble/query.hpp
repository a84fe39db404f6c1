// Filters and results of World's queries: ray casts, shape casts, overlaps and nearest shapes.
//
// Positions are double, in world coordinates, m. Queries use the poses after the last step. Answers depend on the state
// of the world only, not on its history: of equal hits the one with the lowest shape id is first.
#pragma once

#include "tumble/body.hpp"
#include "tumble/distance.hpp"
#include "tumble/id.hpp"
#include "tumble/math.hpp"

namespace tumble {

// Which shapes a query includes.
struct QueryFilter {
    CollisionFilter shape{};  // includes the shapes that a shape with this filter collides with
    BodyId except{};          // leaves out the shapes of this body
    bool sensors = false;     // includes sensors
};

// Where a ray or a moving shape first touches a shape.
struct CastHit {
    ShapeId shape;
    BodyId body;
    double fraction = 0.0;       // of the translation, in [0, 1]
    DVec2 point;                 // world, on the surface of the shape that is hit
    DVec2 normal;                // world, unit, out of the shape that is hit
    bool starts_inside = false;  // a moving shape overlaps it at the start: fraction is 0, point and normal are not set
};

// The nearest shape to a point, and its nearest surface point.
struct ClosestHit {
    ShapeId shape;
    BodyId body;
    double distance = 0.0;  // m, signed: negative if the point is inside the shape
    DVec2 point;            // world, on the shape's surface
    DVec2 normal;           // world, unit, out of the shape
};

// The nearest pair of shapes of two bodies.
struct BodyDistance {
    DistanceResult nearest;  // A is the first body; DistanceStatus::invalid if a body has no solid shape
    ShapeId shape_a;         // not valid then
    ShapeId shape_b;
};

}  // namespace tumble
