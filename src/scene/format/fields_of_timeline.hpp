// The scene fields of events, and of the frame in which events and claims measure. Part of fields.hpp.
#pragma once

#include "scene/format/fields_of_bodies.hpp"

namespace tumble::scene {

template <class V>
void visit_fields(V& v, Type<SceneFrame>) {
    v.field({"position", "Position of the frame's origin in the world.", "m", kPosition}, &SceneFrame::position);
    v.field({"angle", "Rotation of the frame.", "degrees"}, &SceneFrame::angle);
}

template <class V>
void visit_fields(V& v, Type<SceneEvent>) {
    v.field({"at", "Time of a single event.", "s", kTime}, &SceneEvent::at);
    v.field({"every", "Interval of a repeated event, which happens first at time 0 or at 'from'.", "s", kInterval},
            &SceneEvent::every);
    v.field({.name = "when",
             .description =
                 "Condition on the state, for example \"touching(ball, bell)\": the event happens once, when the "
                 "condition first holds.",
             .text = Text::expression},
            &SceneEvent::when);
    v.exactly_one({"at", "every", "when"});
    v.field({"delay", "Time from the state in which 'when' first holds to the event.", "s", kTime}, &SceneEvent::delay);
    v.field({"frame", "Coordinate frame in which 'when' measures. Default: that of the world."}, &SceneEvent::frame);
    v.field({"from", "Time of the first repetition.", "s", kTime}, &SceneEvent::from);
    v.field({"until", "Time of the last repetition, or the end of a force or torque.", "s", kTime}, &SceneEvent::until);
    v.field({.name = "body", .description = "Name of the body that the event acts on.", .text = Text::name},
            &SceneEvent::body);
    v.field({.name = "joint", .description = "Name of the joint that the event acts on.", .text = Text::name},
            &SceneEvent::joint);
    v.field({"impulse", "Impulse applied at the centre of mass of the body.", "N s", kForce}, &SceneEvent::impulse);
    v.field({"angular_impulse", "Angular impulse applied to the body.", "N m s", kForce}, &SceneEvent::angular_impulse);
    v.field({"force", "Force applied at the centre of mass of the body, from then on.", "N", kForce},
            &SceneEvent::force);
    v.field({"torque", "Torque applied to the body, from then on.", "N m", kForce}, &SceneEvent::torque);
    v.field({"velocity", "New velocity of the body.", "m/s"}, &SceneEvent::velocity);
    v.field({"angular_velocity", "New angular velocity of the body.", "degrees/s"}, &SceneEvent::angular_velocity);
    v.field({"motor_speed", "New speed of the joint's motor: degrees/s if it rotates, m/s if it slides."},
            &SceneEvent::motor_speed);
    v.field({"target", "New world point that a mouse joint pulls its body to.", "m", kPosition}, &SceneEvent::target);
    v.field({"gravity", "New gravity of the world.", "m/s^2"}, &SceneEvent::gravity);
    v.field({"spawn", "Body that is created. With 'every', the bodies are named name[0], name[1] and so on."},
            &SceneEvent::spawn);
    v.field({.name = "despawn", .description = "Name of a body that is removed.", .text = Text::name},
            &SceneEvent::despawn);
    v.field({.name = "release", .description = "Name of a joint that is removed.", .text = Text::name},
            &SceneEvent::release);
    v.field({"stop", "true: the run ends."}, &SceneEvent::stop);
    v.exactly_one({"impulse", "angular_impulse", "force", "torque", "velocity", "angular_velocity", "motor_speed",
                   "target", "gravity", "spawn", "despawn", "release", "stop"});
}

}  // namespace tumble::scene
