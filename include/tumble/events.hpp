// Events of a step, as lists sorted by ids, and the contacts after it. Each event is in the list of the step in which
// it happened.
#pragma once

#include <cstdint>
#include <vector>

#include "tumble/id.hpp"
#include "tumble/math.hpp"

namespace tumble {

// Two shapes began to touch: their surfaces touched, or an impulse kept them apart.
struct ContactBegin {
    ShapeId shape_a;
    ShapeId shape_b;
    DVec2 point;                  // world, m: the deepest contact point, at the start of the step
    Vec2 normal;                  // unit, from A to B, world axes
    float approach_speed = 0.0f;  // at the point, before the impact, m/s; negative if the shapes were separating
};

// An impact at a contact point, for sounds and damage: an impulse at a point that had none, and an approach speed of at
// least 1 m/s (times the square root of WorldDef::scale). It happens when two shapes begin to touch, or later: a plank
// that rests on one end and falls over hits with the other. A contact has at most one hit in a step, and none in the
// next.
struct ContactHit {
    ShapeId shape_a;
    ShapeId shape_b;
    DVec2 point;  // as in ContactBegin
    Vec2 normal;
    float approach_speed = 0.0f;
};

// Two shapes ceased to touch, or one of them was destroyed or disabled. The id of a destroyed shape is stale. Shapes
// that touch within a step and are apart at its end cease in the next step. If they touch again in that step, it lists
// their end and their begin: the end is that of the step before.
struct ContactEnd {
    ShapeId shape_a;
    ShapeId shape_b;

    friend constexpr auto operator<=>(const ContactEnd&, const ContactEnd&) = default;
};

// A shape entered or left a sensor. If it left, either of the two may have been destroyed. A dynamic body that moves by
// more than half its size in a step may cross a sensor within the step: it enters and leaves in the same step.
struct SensorEvent {
    ShapeId sensor;
    ShapeId visitor;

    friend constexpr auto operator<=>(const SensorEvent&, const SensorEvent&) = default;
};

struct StepEvents {
    std::vector<ContactBegin> contact_begins;
    std::vector<ContactEnd> contact_ends;
    std::vector<ContactHit> contact_hits;
    std::vector<SensorEvent> sensor_begins;
    std::vector<SensorEvent> sensor_ends;
    std::vector<JointId> broken_joints;  // their ids are stale; gears destroyed with them are not listed
    std::vector<BodyId> fell_asleep;
};

// A contact point of two shapes after a step.
struct ContactPoint {
    BodyId body_a;
    BodyId body_b;
    ShapeId shape_a;
    ShapeId shape_b;
    DVec2 point;                // world, half way between the surfaces, m
    Vec2 normal;                // world, unit, from A to B
    std::uint32_t feature = 0;  // identifies the point of this pair from step to step (manifold.hpp)
    float separation = 0.0f;    // m, negative if the shapes overlap

    // The impulse of A on B in the whole step, N s: along the normal (>= 0), and along the normal rotated by 90 degrees
    // clockwise. The normal impulses under a resting body add up to its weight times the duration of the step.
    float normal_impulse = 0.0f;
    float tangent_impulse = 0.0f;
};

// Two shapes whose bounding boxes overlap, or that touched in the last step. Most such pairs do not touch.
struct ShapePair {
    ShapeId a;
    ShapeId b;
};

}  // namespace tumble
