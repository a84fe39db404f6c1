// The scene fields of claims. Part of fields.hpp.
#pragma once

#include "scene/format/fields_of_timeline.hpp"

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

// Limits for the whole run, and the body or joint that a claim is about.
template <class V>
void visit_limits_of_run(V& v) {
    v.field({"at_rest_by", "Time from which every dynamic body must be at rest: asleep, or slower than 0.05 m/s.", "s",
             kTime},
            &SceneExpectation::at_rest_by);
    v.field(
        {"max_penetration",
         "Greatest allowed depth of an overlap. Bodies that rest or land overlap by less than 0.01 m; with impacts "
         "at the step's end, a body that lands at v may overlap by up to v / steps_per_second - 0.02 m in the first "
         "step.",
         "m", kRounding},
        &SceneExpectation::max_penetration);
    v.field(
        {"max_joint_error", "Greatest allowed distance between the anchors of a joint: of 'joint', or of every joint.",
         "m", kRounding},
        &SceneExpectation::max_joint_error);
    v.field(
        {"max_energy_gain", "Greatest allowed increase of kinetic plus potential energy above their sum at the start.",
         "J", kStrength},
        &SceneExpectation::max_energy_gain);
    v.field({.name = "body",
             .description = "Name of the body that the claim is about. The common name of copies means every copy in "
                            "claims about position, angle and speed, and any copy in claims about touching.",
             .text = Text::name},
            &SceneExpectation::body);
    v.field({.name = "joint", .description = "Name of the joint that the claim is about.", .text = Text::name},
            &SceneExpectation::joint);
}

// Where a body is, how it moves and what it touches.
template <class V>
void visit_claims_of_body(V& v) {
    v.field(
        {"inside", "Lower left and upper right corner of a box that must contain the body's position.", "m", kPosition},
        &SceneExpectation::inside);
    v.field({"outside", "Lower left and upper right corner of a box that must not contain the body's position.", "m",
             kPosition},
            &SceneExpectation::outside);
    v.field({"height", "Least and greatest allowed y of the body's position.", "m", kPosition},
            &SceneExpectation::height);
    v.field({"speed", "Least and greatest allowed speed of the body's centre of mass.", "m/s", kNotNegative},
            &SceneExpectation::speed);
    v.field(
        {"angle", "Least and greatest allowed angle of the body, between -180 and 180.", "degrees", {-180.0, 180.0}},
        &SceneExpectation::angle);
    v.field({.name = "touches",
             .description =
                 "Name of a body that the body must touch at least once. The common name of copies means any of them.",
             .text = Text::name},
            &SceneExpectation::touches);
    v.field(
        {.name = "never_touches",
         .description = "Name of a body that the body must never touch. The common name of copies means all of them.",
         .text = Text::name},
        &SceneExpectation::never_touches);
}

// How many bodies are in a region, and how many events happened.
template <class V>
void visit_claims_of_counts(V& v) {
    v.field({"count",
             "Least and greatest allowed number of bodies whose position is in 'region': of the copies of 'body', or "
             "of all. Static bodies do not count.",
             "",
             {0.0, 1e9}},
            &SceneExpectation::count);
    v.field({"region", "Lower left and upper right corner of the box in which 'count' counts bodies.", "m", kPosition},
            &SceneExpectation::region);
    v.field({"event_count",
             "Least and greatest allowed number of events of the kind 'event' so far: those of 'body', or all.",
             "",
             {0.0, 1e9}},
            &SceneExpectation::event_count);
    v.field({"event", "Kind of the events that 'event_count' counts."}, &SceneExpectation::event);
}

// The state as a whole, or a condition on it.
template <class V>
void visit_claims_of_state(V& v) {
    v.field({.name = "state_hash",
             .description = "Expected state hash: 16 hexadecimal digits, as the run command prints them.",
             .text = Text::hash},
            &SceneExpectation::state_hash);
    v.field({.name = "that",
             .description = "Condition on the state that must hold, for example \"a.x < b.x - 1\".",
             .text = Text::expression},
            &SceneExpectation::that);
    v.field(
        {.name = "before",
         .description = "Condition: 'that' must hold in a state before the first one in which this condition holds.",
         .text = Text::expression},
        &SceneExpectation::before);
}

// The time of a step and the frame, compared with those of another file.
template <class V>
void visit_claims_with_reference(V& v) {
    v.field(
        {"max_ms_per_step", "Greatest allowed mean time of a step, on the wall clock.", "ms", {0.0, kLongest, true}},
        &SceneExpectation::max_ms_per_step);
    v.field({"max_time_ratio",
             "Greatest allowed ratio of the time of a step to that of the scene 'reference', which the check command "
             "measures in turns.",
             "", kInterval},
            &SceneExpectation::max_time_ratio);
    v.field({.name = "reference",
             .description = "Path of the scene file that 'max_time_ratio' compares with, relative to the folder of the "
                            "scene.",
             .text = Text::name},
            &SceneExpectation::reference);
    v.field({.name = "picture",
             .description =
                 "Path of a PNG file, relative to the folder of the scene, that the frame of its size must equal "
                 "at the end or at 'at'. The check command draws it.",
             .text = Text::png_file},
            &SceneExpectation::picture);
    v.field({"tolerance",
             "Greatest allowed difference of a colour component of a pixel from 'picture', in levels.",
             "",
             {0.0, 255.0}},
            &SceneExpectation::tolerance);
}

// In which frame and at which times a claim is evaluated.
template <class V>
void visit_moments(V& v) {
    v.field(
        {"frame",
         "Coordinate frame in which boxes, heights, angles and conditions are measured. Default: that of the world."},
        &SceneExpectation::frame);
    v.field({"when",
             "When a claim about a state must hold. end: in the last state; always: in every state; sometime: in at "
             "least one."},
            &SceneExpectation::when);
    v.field({"at", "Time of the one state in which the claim must hold.", "s", kTime}, &SceneExpectation::at);
    v.field({"from", "Time before which states and events are not counted.", "s", kTime}, &SceneExpectation::from);
    v.field({"until", "Time after which states and events are not counted.", "s", kTime}, &SceneExpectation::until);
}

// The order of the calls is the order in which keys are written.
template <class V>
void visit_fields(V& v, Type<SceneExpectation>) {
    visit_limits_of_run(v);
    visit_claims_of_body(v);
    visit_claims_of_counts(v);
    visit_claims_of_state(v);
    visit_claims_with_reference(v);
    v.exactly_one({"at_rest_by", "max_penetration", "max_joint_error", "max_energy_gain", "inside", "outside", "height",
                   "speed", "angle", "touches", "never_touches", "count", "event_count", "state_hash", "that",
                   "max_ms_per_step", "max_time_ratio", "picture"});
    visit_moments(v);
}

}  // namespace tumble::scene
