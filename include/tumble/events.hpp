// What happened in a step, as lists in order of ids: nothing is lost, and nothing comes a step late.
#pragma once

#include <vector>

#include "tumble/id.hpp"
#include "tumble/math.hpp"

namespace tumble {

// Two shapes began to touch: their surfaces met, or an impulse was needed to keep them apart. A hit is one with a high
// approach speed.
struct ContactBegin {
    ShapeId shape_a;
    ShapeId shape_b;
    DVec2 point;  // world, where they were about to meet at the start of the step
    Vec2 normal;  // from A to B
    float approach_speed =
        0.0f;  // at the point, before anything stopped it, m/s; negative if they were parting already
};

// They touch no more, or one of them was destroyed: its id is stale then.
struct ContactEnd {
    ShapeId shape_a;
    ShapeId shape_b;

    friend constexpr auto operator<=>(const ContactEnd&, const ContactEnd&) = default;
};

// A shape entered or left a sensor. Either may have been destroyed if it left.
struct SensorEvent {
    ShapeId sensor;
    ShapeId visitor;

    friend constexpr auto operator<=>(const SensorEvent&, const SensorEvent&) = default;
};

struct StepEvents {
    std::vector<ContactBegin> contact_begins;
    std::vector<ContactEnd> contact_ends;
    std::vector<SensorEvent> sensor_begins;
    std::vector<SensorEvent> sensor_ends;
    std::vector<JointId> broken_joints;  // their ids are stale now
    std::vector<BodyId> fell_asleep;
};

}  // namespace tumble
