// What happened in a step, as lists in order of ids: nothing is lost, and nothing comes a step late.
#pragma once

#include <vector>

#include "tumble/id.hpp"
#include "tumble/math.hpp"

namespace tumble {

// Two shapes began to touch: their surfaces met, or an impulse was needed to keep them apart.
struct ContactBegin {
    ShapeId shape_a;
    ShapeId shape_b;
    DVec2 point;  // world, where they were about to meet at the start of the step
    Vec2 normal;  // from A to B
    float approach_speed =
        0.0f;  // at the point, before anything stopped it, m/s; negative if they were parting already
};

// A point was struck, to be heard or to do damage: it bears a load that it did not bear before, and was approached at 1
// m/s or more (times the root of WorldDef::scale). As two shapes begin to touch, or later: a plank that falls over its
// one end hits with the other. A contact has one at most in a step, and none in the step after.
struct ContactHit {
    ShapeId shape_a;
    ShapeId shape_b;
    DVec2 point;  // as of ContactBegin
    Vec2 normal;
    float approach_speed = 0.0f;
};

// They touch no more, or one of them was destroyed: its id is stale then.
struct ContactEnd {
    ShapeId shape_a;
    ShapeId shape_b;

    friend constexpr auto operator<=>(const ContactEnd&, const ContactEnd&) = default;
};

// A shape entered or left a sensor. Either may have been destroyed if it left. A dynamic body that continuous collision
// sweeps, as it moves by more than half its size in a step, may pass a sensor within one: it enters and leaves in that
// step.
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
    std::vector<JointId> broken_joints;  // their ids are stale now; gears that went with them are not among them
    std::vector<BodyId> fell_asleep;
};

}  // namespace tumble
