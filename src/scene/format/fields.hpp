// The table of scene fields: name, member, unit, range and meaning of everything a scene file can say, once.
//
// visit_fields(visitor, Type<T>) names the fields of T in the order in which they are written. The reader, the writer
// and the JSON schema are three visitors of it, so they cannot disagree. A visitor has
//   field(Field, member)             a value: number, text, vector, list, object, or an optional one of these
//   pair(Field, member, member)      two texts as an array
//   named(Field, member)             a list as an object whose keys are the names of its elements
//   json(Field, member)              any JSON value, kept as text
//   constant(Field, number)          a number that must be there
//   one_of(Field, member)            a variant whose alternatives are keys of this very object
//   exactly_one({names})             of these optional keys, one must be there
//   at_most_one(name, name)          of these optional keys, one or none
// and visit_alternatives(visitor, Type<Variant>) calls alternative<T>(name, description). Defaults are those of the
// structs themselves. Errors across fields are found by validate_scene().
#pragma once

#include "scene/format/fields_of_runs.hpp"

namespace tumble::scene {

template <class V>
void visit_fields(V& v, Type<SceneSettings>) {
    v.field({"gravity", "Acceleration of all dynamic bodies.", "m/s^2"}, &SceneSettings::gravity);
    v.field({"steps_per_second", "Steps of the simulation in a second.", "Hz", {1.0, 1e5}},
            &SceneSettings::steps_per_second);
    v.field({"substeps", "Parts that the solver divides a step into.", "", {1.0, 1000.0}}, &SceneSettings::substeps);
    v.field({"duration", "Simulated time of a run.", "s", kTime}, &SceneSettings::duration);
    v.field({"seed", "Where the random numbers of scatter repeaters start.", "", kSeed}, &SceneSettings::seed);
    v.field({"sleeping", "Whether bodies at rest fall asleep."}, &SceneSettings::sleeping);
    v.field({"continuous", "Whether fast bodies are kept from passing through thin ones."}, &SceneSettings::continuous);
    v.field({"scale",
             "Size of a typical body: 1 for human scale, 0.02 for marbles. The stepper's own lengths, speeds and "
             "frequencies follow; the step rate is to be 1 / sqrt(scale) times as high.",
             "m",
             {1e-4, 1e4}},
            &SceneSettings::scale);
}

template <class V>
void visit_fields(V& v, Type<SceneCamera>) {
    v.field({"center",
             "World point in the middle of the frame; left out: chosen so that all is in view that moves, its way as "
             "far as it "
             "stays near, the ground below and what stands near. With follow: where the middle is when the body is "
             "first seen.",
             "m", kPosition},
            &SceneCamera::center);
    v.field(
        {"height",
         "Height of the world in the frame; left out: as for center. With follow: five times the body's larger side.",
         "m",
         {0.0, kFarthest, true}},
        &SceneCamera::height);
    v.field(
        {.name = "follow",
         .description =
             "Name of a body that the frame moves with: it stays in the middle, or where center puts it. A body of the "
             "timeline is followed from when it is made.",
         .text = Text::name},
        &SceneCamera::follow);
}

template <class V>
void visit_fields(V& v, Type<SceneMaterial>) {
    v.field({"density", "Mass of a square metre.", "kg/m^2", kNotNegative}, &SceneMaterial::density);
    v.field({"friction", "Of two surfaces, the square root of the product counts.", "", kNotNegative},
            &SceneMaterial::friction);
    v.field({"restitution",
             "Part of the speed that a bounce gives back; of two surfaces, the larger counts.",
             "",
             {0.0, 1.0}},
            &SceneMaterial::restitution);
    v.field({"rolling_resistance", "Lever arm of the resistance to rolling, in radii of the shape.", "", kNotNegative},
            &SceneMaterial::rolling_resistance);
    v.field({"tangent_speed", "Speed of a conveyor belt; positive carries what lies on top to the left.", "m/s"},
            &SceneMaterial::tangent_speed);
    v.field({.name = "color", .description = "#rgb or #rrggbb; left out: by type and name.", .text = Text::color},
            &SceneMaterial::color);
}

template <class V>
void visit_fields(V& v, Type<SceneInclude>) {
    v.field({.name = "file",
             .description = "Path of a scene file, from the folder of this one.",
             .required = true,
             .text = Text::name},
            &SceneInclude::file);
    v.field({"position", "Where the origin of that scene comes to lie.", "m", kPosition}, &SceneInclude::position);
    v.field({"angle", "Turn of that scene about its origin.", "degrees"}, &SceneInclude::angle);
    v.field({"prefix", "Put before each of its names, so that a file can be included twice: \"car1/\"."},
            &SceneInclude::prefix);
}

template <class V>
void visit_fields(V& v, Type<Scene>) {
    v.field({"$schema", "Where editors find this schema."}, &Scene::schema);
    v.constant({.name = "format", .description = "Version of the file format.", .required = true}, 1);
    v.field({"name", "Names the output folder; left out: the file's name."}, &Scene::name);
    v.field({"description", "What there is to see."}, &Scene::description);
    v.field({"world", "The world and its run."}, &Scene::world);
    v.field({"camera", "What the frames show."}, &Scene::camera);
    v.field(
        {.name = "include",
         .description =
             "Other scenes, placed in this one: their bodies, joints, materials, events and claims. Their world and "
             "camera, changes of gravity and claims of the whole world stay behind.",
         .max_items = 10000},
        &Scene::include);
    v.named({"materials", "Surfaces, by name."}, &Scene::materials);
    v.field({.name = "bodies", .description = "The bodies.", .max_items = 1000000}, &Scene::bodies);
    v.field({.name = "joints", .description = "What ties bodies together.", .max_items = 1000000}, &Scene::joints);
    v.field({"timeline", "What happens during the run."}, &Scene::timeline);
    v.field({"expect", "What must be true; tested by check."}, &Scene::expect);
    v.json({"custom", "Anything a user wants to keep."}, &Scene::custom);
}

}  // namespace tumble::scene
