// Questions to a world: rays, moving shapes, overlaps, nearest things. Asked through World's members.
//
// All positions are in double. Answers depend on what is in the world, never on how it came there: of equal hits the
// one with the lowest shape id is first. Queries see the poses at the end of the last step.
#pragma once

#include "tumble/body.hpp"
#include "tumble/distance.hpp"
#include "tumble/id.hpp"
#include "tumble/math.hpp"

namespace tumble {

// Which shapes a query sees: those that a shape with this filter would meet.
struct QueryFilter {
    CollisionFilter shape{};
    BodyId except{};       // a body that is not seen: the one that asks
    bool sensors = false;  // whether sensors are seen
};

// Where a ray or a moving shape meets a shape first.
struct CastHit {
    ShapeId shape;
    BodyId body;
    double fraction = 0.0;       // of the way, in [0, 1]
    DVec2 point;                 // world, on the shape's surface
    DVec2 normal;                // unit, out of the shape
    bool starts_inside = false;  // of a moving shape alone: it overlaps at the start; then there is no point and normal
};

// The point of a shape that is nearest to a given one.
struct ClosestHit {
    ShapeId shape;
    BodyId body;
    double distance = 0.0;  // m, signed: negative inside
    DVec2 point;            // world, on the shape's surface
    DVec2 normal;           // unit, out of the shape
};

// The nearest pair of shapes of two bodies.
struct BodyDistance {
    DistanceResult nearest;  // A is the first body; `invalid` if one of them has no solid shape
    ShapeId shape_a;
    ShapeId shape_b;
};

}  // namespace tumble
