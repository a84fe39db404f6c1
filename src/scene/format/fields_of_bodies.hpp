// The scene fields of bodies and repeaters. Part of fields.hpp.
#pragma once

#include "scene/format/fields_of_shapes.hpp"

namespace tumble::scene {

template <>
inline constexpr std::array<std::pair<BodyType, std::string_view>, 3> kEnumNames<BodyType>{
    {{BodyType::static_body, "static"}, {BodyType::kinematic_body, "kinematic"}, {BodyType::dynamic_body, "dynamic"}}};

inline constexpr Field kPatternAngle{
    "angle", "Rotation of the whole pattern about the body's position. The copies keep their own angles.", "degrees"};

template <class V>
void visit_fields(V& v, Type<GridRepeat>) {
    v.field({"columns", "Copies in a row.", "", kCount}, &GridRepeat::columns);
    v.field({"rows", "Number of rows, from the lowest upwards.", "", kCount}, &GridRepeat::rows);
    v.field({"spacing", "Distance from one column to the next and from one row to the next.", "m", kCoordinate},
            &GridRepeat::spacing);
    v.field(kPatternAngle, &GridRepeat::angle);
}

template <class V>
void visit_fields(V& v, Type<PyramidRepeat>) {
    v.field({"base", "Copies in the lowest row. Each row above has one fewer.", "", {1.0, 1413.0}, true},
            &PyramidRepeat::base);
    v.field({"spacing", "Distance from one copy to the next in a row, and from one row to the next.", "m", kCoordinate},
            &PyramidRepeat::spacing);
    v.field(kPatternAngle, &PyramidRepeat::angle);
}

template <class V>
void visit_fields(V& v, Type<RingRepeat>) {
    v.field({"count", "Copies on the ring, counter-clockwise from its rightmost point.", "", kCount, true},
            &RingRepeat::count);
    v.field({"radius", "Radius of the ring.", "m", kLength}, &RingRepeat::radius);
    v.field({"turn", "Whether each copy is rotated by its angle on the ring, measured from the first copy."},
            &RingRepeat::turn);
    v.field(kPatternAngle, &RingRepeat::angle);
}

template <class V>
void visit_fields(V& v, Type<ScatterRepeat>) {
    v.field({"count", "Number of copies.", "", kCount, true}, &ScatterRepeat::count);
    v.field({"size",
             "Width and height of the box around the body's position in which the copies are placed.",
             "m",
             {0.0, kFarthest}},
            &ScatterRepeat::size);
    v.field({"turn", "Whether each copy is rotated by a random angle."}, &ScatterRepeat::turn);
    v.field({"separation", "Least distance between the positions of two copies.", "m", kRounding},
            &ScatterRepeat::separation);
    v.field(kPatternAngle, &ScatterRepeat::angle);
}

template <class V>
void visit_alternatives(V& v, Type<SceneRepeat>) {
    v.template alternative<GridRepeat>(
        "grid", "Copies in rows and columns, from the body's position to the right and upwards.");
    v.template alternative<PyramidRepeat>(
        "pyramid",
        "Rows that shorten by one copy, each centred on the row below; the lowest starts at the body's position.");
    v.template alternative<RingRepeat>("ring", "Copies on a circle about the body's position.");
    v.template alternative<ScatterRepeat>("scatter", "Copies at random positions in a box about the body's position.");
}

template <class V>
void visit_fields(V& v, Type<SceneMass>) {
    v.field({"mass", "Mass of the body.", "kg", kPositive, true}, &SceneMass::mass);
    v.field({"center", "Centre of mass, in body coordinates.", "m", kCoordinate}, &SceneMass::center);
    v.field({"inertia", "Moment of inertia about the centre of mass. With 0 the body does not rotate.", "kg m^2",
             kStrength, true},
            &SceneMass::inertia);
}

template <class V>
void visit_fields(V& v, Type<SceneImage>) {
    v.field({.name = "file",
             .description = "Path of a PNG, JPEG or BMP file, from the folder of the scene's file. Frames show the "
                            "outline of the image if there is no such file.",
             .required = true},
            &SceneImage::file);
    v.field({"center", "Middle of the image, in body coordinates.", "m", kCoordinate}, &SceneImage::center);
    v.field({"angle", "Rotation of the image in the body, counter-clockwise.", "degrees"}, &SceneImage::angle);
    v.field({"height", "Height of the image.", "m", kLength, true}, &SceneImage::height);
    v.field({"width", "Width of the image. Default: as the proportions of the file.", "m", kLength},
            &SceneImage::width);
    v.field({"flip", "Whether left and right are swapped."}, &SceneImage::flip);
    v.field({"opacity", "0 is invisible, 1 opaque.", "", {0.0, 1.0}}, &SceneImage::opacity);
    v.field({"order",
             "Images with higher numbers cover those with lower ones. Below 0 an image is behind all bodies.",
             "",
             {-1e6, 1e6}},
            &SceneImage::order);
}

template <class V>
void visit_fields(V& v, Type<SceneBody>) {
    v.field({.name = "name",
             .description = "Unique name. Copies are named name[0], name[1] and so on.",
             .text = Text::name},
            &SceneBody::name);
    v.field({"type",
             "static: never moves; kinematic: moves at its own velocity, whatever it touches; dynamic: moves under "
             "gravity, forces, contacts and joints."},
            &SceneBody::type);
    v.field({"position", "Position of the body's origin in the world.", "m", kPosition}, &SceneBody::position);
    v.field({"angle", "Rotation about the body's origin, counter-clockwise.", "degrees"}, &SceneBody::angle);
    v.field({"velocity", "Initial velocity of the centre of mass.", "m/s"}, &SceneBody::velocity);
    v.field({"angular_velocity", "Initial angular velocity, counter-clockwise.", "degrees/s"},
            &SceneBody::angular_velocity);
    v.field({"linear_damping", "Damping of the velocity: for small values, the fraction lost in a second.", "1/s",
             kNotNegative},
            &SceneBody::linear_damping);
    v.field({"angular_damping", "Damping of the angular velocity: for small values, the fraction lost in a second.",
             "1/s", kNotNegative},
            &SceneBody::angular_damping);
    v.field({"gravity_scale", "Factor by which the world's gravity is multiplied for this body."},
            &SceneBody::gravity_scale);
    v.field({"bullet",
             "Whether a fast body is swept against dynamic bodies too, so that it does not pass through them. With "
             "'impacts' in order, every fast body is."},
            &SceneBody::bullet);
    v.field({"awake", "false: a dynamic body starts asleep and stays at rest until something touches it."},
            &SceneBody::awake);
    v.field({"fixed_rotation", "Whether the body never rotates."}, &SceneBody::fixed_rotation);
    v.field({"lock_x", "Whether the body never moves along the world's x axis."}, &SceneBody::lock_x);
    v.field({"lock_y", "Whether the body never moves along the world's y axis."}, &SceneBody::lock_y);
    v.field({"enabled", "false: the body is drawn, but does not move and collides with nothing."}, &SceneBody::enabled);
    v.field({"allow_sleep", "false: the body never falls asleep, and neither do the bodies that touch it."},
            &SceneBody::allow_sleep);
    v.field({"allow_fast_rotation",
             "Whether the body may rotate by more than an eighth of a turn in a step. For round bodies."},
            &SceneBody::allow_fast_rotation);
    v.field({"mass", "Mass properties that replace those of the shapes."}, &SceneBody::mass);
    v.field({"repeat", "Pattern of copies of the body."}, &SceneBody::repeat);
    v.field({"trail", "Whether frames show the path of the body so far. No effect on the simulation."},
            &SceneBody::trail);
    v.field(
        {"skin",
         "Whether frames fill the closed loop through the copies of the body, as the skin of a soft body. No effect "
         "on the simulation."},
        &SceneBody::skin);
    v.field({"shapes", "Shapes that make up the body."}, &SceneBody::shapes);
    v.field({"images", "Pictures that frames show on the body. No effect on the simulation."}, &SceneBody::images);
    v.json({"custom", "Any JSON value: kept with the body, without effect on the simulation."}, &SceneBody::custom);
}

}  // namespace tumble::scene
