// The one table of scene fields: name, member, unit, range and meaning of every key of a scene file.
//
// visit_fields(visitor, Type<T>) names the fields of T in the order in which they are written. The reader, the writer
// and the JSON schema are three visitors of it, so they cannot disagree. A visitor has
//   field(Field, member)             a value: number, text, vector, list, object, or an optional one of these
//   pair(Field, member, member)      two texts as an array
//   named(Field, member)             a list as an object whose keys are the names of its elements
//   json(Field, member)              any JSON value, kept as text
//   constant(Field, number)          a key whose value must be this number
//   one_of(Field, member)            a variant whose alternatives are keys of this object
//   exactly_one({names})             exactly one of these optional keys must be present
//   at_most_one(name, name)          at most one of these optional keys may be present
// and visit_alternatives(visitor, Type<Variant>) calls alternative<T>(name, description). The defaults are
// those of the structs. Errors across fields are found by validate_scene().
#pragma once

#include "scene/format/fields_of_claims.hpp"
#include "scene/format/fields_of_frames.hpp"
#include "scene/format/fields_of_joints.hpp"

namespace tumble::scene {

template <>
inline constexpr std::array<std::pair<JointSolver, std::string_view>, 2> kEnumNames<JointSolver>{
    {{JointSolver::iterative, "iterative"}, {JointSolver::direct, "direct"}}};

template <>
inline constexpr std::array<std::pair<ImpactModel, std::string_view>, 2> kEnumNames<ImpactModel>{
    {{ImpactModel::at_step_end, "at_step_end"}, {ImpactModel::in_order, "in_order"}}};

template <class V>
void visit_fields(V& v, Type<SceneSettings>) {
    v.field({"gravity", "Gravitational acceleration of dynamic bodies.", "m/s^2"}, &SceneSettings::gravity);
    v.field({"steps_per_second", "Simulation steps in a second of simulated time.", "Hz", {1.0, 1e5}},
            &SceneSettings::steps_per_second);
    v.field(
        {"substeps", "Solver sub-steps in a step. More sub-steps make joints and stacks stiffer.", "", {1.0, 1000.0}},
        &SceneSettings::substeps);
    v.field({"duration", "Simulated time of a run.", "s", kTime}, &SceneSettings::duration);
    v.field(
        {"seed", "Seed of the positions of scatter repeaters and of numbers that are declared as random.", "", kSeed},
        &SceneSettings::seed);
    v.field({"sleeping", "Whether bodies at rest fall asleep, which saves computing time."}, &SceneSettings::sleeping);
    v.field({"continuous",
             "Whether fast bodies are swept, so that they do not pass through thin ones: against all others, or with "
             "'impacts' at the step's end against static and kinematic bodies only."},
            &SceneSettings::continuous);
    v.field({"joints",
             "How joints are solved: 'iterative', one after the other, or 'direct', all at once. Direct joints do not "
             "open under load and keep the energy of pendulums and chains, but take longer."},
            &SceneSettings::joints);
    v.field({"impacts",
             "When impacts happen: 'in_order', each at its time within the step, or 'at_step_end'. In order, bounces "
             "keep their energy and their times, and fast bodies collide with all others. At the step's end a step is "
             "faster."},
            &SceneSettings::impacts);
    v.field({"scale",
             "Size of a typical body: 1 for human scale, 0.02 for marbles. The lengths, speeds and frequencies inside "
             "the solver scale with it. Multiply 'steps_per_second' by 1 / sqrt(scale).",
             "m",
             {1e-4, 1e4}},
            &SceneSettings::scale);
}

template <class V>
void visit_fields(V& v, Type<SceneMaterial>) {
    v.field({"density", "Mass of a square metre.", "kg/m^2", kNotNegative}, &SceneMaterial::density);
    v.field({"friction", "Coefficient of friction. Two touching surfaces use the square root of the product of theirs.",
             "", kNotNegative},
            &SceneMaterial::friction);
    v.field({"restitution",
             "Fraction of the approach speed that a bounce returns. Two touching surfaces use the larger of theirs.",
             "",
             {0.0, 1.0}},
            &SceneMaterial::restitution);
    v.field({"rolling_resistance",
             "Resistance to rolling: the lever arm of the resisting torque, in radii of the shape.", "", kNotNegative},
            &SceneMaterial::rolling_resistance);
    v.field(
        {"tangent_speed",
         "Speed of the surface, for conveyor belts. A positive speed carries bodies on top of it to the left.", "m/s"},
        &SceneMaterial::tangent_speed);
    v.field({.name = "color",
             .description = "Fill colour, #rgb or #rrggbb. Default: chosen by the body's type and name.",
             .text = Text::color},
            &SceneMaterial::color);
}

template <class V>
void visit_fields(V& v, Type<SceneInclude>) {
    v.field({.name = "file",
             .description = "Path of the included scene file, relative to the folder of the including file.",
             .required = true,
             .text = Text::name},
            &SceneInclude::file);
    v.field({"position", "Position of the included scene's origin in this scene.", "m", kPosition},
            &SceneInclude::position);
    v.field({"angle", "Rotation of the included scene about its origin.", "degrees"}, &SceneInclude::angle);
    v.field({"prefix",
             "Text put before every name of the included scene, for example \"car1/\", so that one file can be "
             "included several times."},
            &SceneInclude::prefix);
}

template <class V>
void visit_fields(V& v, Type<Scene>) {
    v.field({"$schema", "Path or address of this schema, for editors."}, &Scene::schema);
    v.constant({.name = "format", .description = "Version of the file format.", .required = true}, 1);
    v.field({"name", "Name of the scene and of its output folder. Default: the file's name."}, &Scene::name);
    v.field({"description", "What the scene shows."}, &Scene::description);
    v.field({"world", "Gravity, step rate, duration and other settings of the world and its run."}, &Scene::world);
    v.field({"camera", "The part of the world that the frames show."}, &Scene::camera);
    v.field({.name = "include",
             .description =
                 "Scene files that become parts of this scene with their bodies, joints, materials, events and claims. "
                 "Their world settings, camera, changes of gravity and claims about the whole world are left out.",
             .max_items = 10000},
            &Scene::include);
    v.named({"materials", "Surface materials, by name."}, &Scene::materials);
    v.field({.name = "bodies", .description = "Rigid bodies.", .max_items = 1000000}, &Scene::bodies);
    v.field({.name = "joints", .description = "Joints, which connect two bodies each.", .max_items = 1000000},
            &Scene::joints);
    v.field(
        {"timeline",
         "Events during the run: impulses, forces, new velocities and motor speeds, bodies that appear or disappear."},
        &Scene::timeline);
    v.field({"expect", "Claims about the run, which the check command tests."}, &Scene::expect);
    v.json({"custom", "Any JSON value: kept with the scene, without effect on the simulation."}, &Scene::custom);
}

}  // namespace tumble::scene
