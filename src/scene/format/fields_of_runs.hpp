// The scene fields of what happens in a run and what is claimed of it. Part of fields.hpp.
#pragma once

#include "scene/format/fields_of_bodies.hpp"

namespace tumble::scene {

template <>
inline constexpr std::array<std::pair<SceneMoment, std::string_view>, 3> kEnumNames<SceneMoment>{
    {{SceneMoment::end, "end"}, {SceneMoment::always, "always"}, {SceneMoment::sometime, "sometime"}}};
template <>
inline constexpr std::array<std::pair<SceneEventKind, std::string_view>, 7> kEnumNames<SceneEventKind>{
    {{SceneEventKind::contact_begin, "contact_begin"},
     {SceneEventKind::contact_end, "contact_end"},
     {SceneEventKind::contact_hit, "contact_hit"},
     {SceneEventKind::sensor_begin, "sensor_begin"},
     {SceneEventKind::sensor_end, "sensor_end"},
     {SceneEventKind::joint_broke, "joint_broke"},
     {SceneEventKind::fell_asleep, "fell_asleep"}}};

template <class V>
void visit_fields(V& v, Type<SceneEvent>) {
    v.field({"at", "Time of a single event.", "s", kTime}, &SceneEvent::at);
    v.field({"every", "Interval of an event that happens again and again, from 0 on or 'from' a time.", "s", kInterval},
            &SceneEvent::every);
    v.exactly_one({"at", "every"});
    v.field({"from", "Time of the first repetition.", "s", kTime}, &SceneEvent::from);
    v.field({"until", "Time of the last repetition, or the end of a force or torque.", "s", kTime}, &SceneEvent::until);
    v.field({.name = "body", .description = "Name of the body that is acted on.", .text = Text::name},
            &SceneEvent::body);
    v.field({.name = "joint", .description = "Name of the joint that is acted on.", .text = Text::name},
            &SceneEvent::joint);
    v.field({"impulse", "Impulse at the centre of mass of the body.", "N s", kForce}, &SceneEvent::impulse);
    v.field({"angular_impulse", "Angular impulse on the body.", "N m s", kForce}, &SceneEvent::angular_impulse);
    v.field({"force", "Force at the centre of mass of the body, from then on.", "N", kForce}, &SceneEvent::force);
    v.field({"torque", "Torque on the body, from then on.", "N m", kForce}, &SceneEvent::torque);
    v.field({"velocity", "The body's velocity from then on.", "m/s"}, &SceneEvent::velocity);
    v.field({"angular_velocity", "The body's angular velocity from then on.", "degrees/s"},
            &SceneEvent::angular_velocity);
    v.field({"motor_speed", "New speed of the joint's motor: degrees/s if it turns, m/s if it slides."},
            &SceneEvent::motor_speed);
    v.field({"target", "World point that the mouse joint pulls to.", "m", kPosition}, &SceneEvent::target);
    v.field({"gravity", "Gravity from then on.", "m/s^2"}, &SceneEvent::gravity);
    v.field({"spawn", "A body that appears; with 'every', copies called name[0], name[1] and so on."},
            &SceneEvent::spawn);
    v.field({.name = "despawn", .description = "Name of a body that goes.", .text = Text::name}, &SceneEvent::despawn);
    v.field({.name = "release", .description = "Name of a joint that goes.", .text = Text::name}, &SceneEvent::release);
    v.exactly_one({"impulse", "angular_impulse", "force", "torque", "velocity", "angular_velocity", "motor_speed",
                   "target", "gravity", "spawn", "despawn", "release"});
}

template <class V>
void visit_fields(V& v, Type<SceneFrame>) {
    v.field({"position", "Where the origin of the frame lies.", "m", kPosition}, &SceneFrame::position);
    v.field({"angle", "Turn of the frame.", "degrees"}, &SceneFrame::angle);
}

template <class V>
void visit_fields(V& v, Type<SceneExpectation>) {
    v.field({"at_rest_by", "Time by which nothing moves any more.", "s", kTime}, &SceneExpectation::at_rest_by);
    v.field({"max_penetration", "Depth that no overlap may pass: 0.01 for what lies, the way of a step for what lands.",
             "m", kRounding},
            &SceneExpectation::max_penetration);
    v.field({"max_joint_error", "How far the anchors of a joint may part, of 'joint' or of every one.", "m", kRounding},
            &SceneExpectation::max_joint_error);
    v.field(
        {"max_energy_gain", "How much kinetic and potential energy may grow above that at the start.", "J", kStrength},
        &SceneExpectation::max_energy_gain);
    v.field({.name = "body",
             .description = "Name of the body that is looked at; the common name of copies means each of them.",
             .text = Text::name},
            &SceneExpectation::body);
    v.field({.name = "joint", .description = "Name of the joint that is looked at.", .text = Text::name},
            &SceneExpectation::joint);
    v.field({"inside", "Lower left and upper right corner of a box that holds the body's position.", "m", kPosition},
            &SceneExpectation::inside);
    v.field({"outside", "Lower left and upper right corner of a box that does not hold the body's position.", "m",
             kPosition},
            &SceneExpectation::outside);
    v.field({"height", "Least and greatest y of the body's position.", "m", kPosition}, &SceneExpectation::height);
    v.field({"speed", "Least and greatest speed of the body's centre of mass.", "m/s", kNotNegative},
            &SceneExpectation::speed);
    v.field({"angle", "Least and greatest angle of the body, between -180 and 180.", "degrees", {-180.0, 180.0}},
            &SceneExpectation::angle);
    v.field({.name = "touches",
             .description = "Name of a body that the body touches at least once; of copies, any of them.",
             .text = Text::name},
            &SceneExpectation::touches);
    v.field({.name = "never_touches",
             .description = "Name of a body that the body never touches; of copies, none of them.",
             .text = Text::name},
            &SceneExpectation::never_touches);
    v.field({"count",
             "Least and greatest number of bodies with their position in 'region', of the copies of 'body' or of all.",
             "",
             {0.0, 1e9}},
            &SceneExpectation::count);
    v.field({"region", "Lower left and upper right corner of the box that 'count' looks at.", "m", kPosition},
            &SceneExpectation::region);
    v.field({"event_count",
             "Least and greatest number of events of the kind 'event' so far, of 'body' or of all.",
             "",
             {0.0, 1e9}},
            &SceneExpectation::event_count);
    v.field({"event", "What 'event_count' counts."}, &SceneExpectation::event);
    v.field({"state_hash", "The state hash, 16 hexadecimal digits as run prints it."}, &SceneExpectation::state_hash);
    v.exactly_one({"at_rest_by", "max_penetration", "max_joint_error", "max_energy_gain", "inside", "outside", "height",
                   "speed", "angle", "touches", "never_touches", "count", "event_count", "state_hash"});
    v.field({"frame", "Coordinates in which boxes, heights and angles are measured; left out: those of the world."},
            &SceneExpectation::frame);
    v.field({"when", "When a claim of a state must hold: at the end, always, or sometime."}, &SceneExpectation::when);
    v.field({"at", "At this time alone.", "s", kTime}, &SceneExpectation::at);
    v.field({"from", "What is before does not count.", "s", kTime}, &SceneExpectation::from);
    v.field({"until", "What is after does not count.", "s", kTime}, &SceneExpectation::until);
}

}  // namespace tumble::scene
