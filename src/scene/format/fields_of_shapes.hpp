// The scene fields of shapes: geometry, filter, what they are made of. Part of fields.hpp.
#pragma once

#include "scene/format/field.hpp"

namespace tumble::scene {

template <class V>
void visit_fields(V& v, Type<CircleGeometry>) {
    v.field({"radius", "Radius.", "m", kRadius, true}, &CircleGeometry::radius);
    v.field({"center", "Centre, in body coordinates.", "m", kCoordinate}, &CircleGeometry::center);
}

template <class V>
void visit_fields(V& v, Type<CapsuleGeometry>) {
    v.field({"from", "Centre of one end.", "m", kCoordinate, true}, &CapsuleGeometry::from);
    v.field({"to", "Centre of the other end.", "m", kCoordinate, true}, &CapsuleGeometry::to);
    v.field({"radius", "Half the thickness.", "m", kRadius, true}, &CapsuleGeometry::radius);
}

template <class V>
void visit_fields(V& v, Type<BoxGeometry>) {
    v.field({"size", "Outer width and height, rounding included.", "m", kLength, true}, &BoxGeometry::size);
    v.field({"radius", "Radius of the rounded corners, at most half the smaller side.", "m", kRounding},
            &BoxGeometry::radius);
    v.field({"center", "Centre, in body coordinates.", "m", kCoordinate}, &BoxGeometry::center);
    v.field({"angle", "Turn about the centre.", "degrees"}, &BoxGeometry::angle);
}

template <class V>
void visit_fields(V& v, Type<PolygonGeometry>) {
    v.field({"vertices", "Points in any order; their convex hull is the polygon.", "m", kCoordinate, true, 3},
            &PolygonGeometry::vertices);
    v.field({"radius", "Grows the polygon and rounds its corners.", "m", kRounding}, &PolygonGeometry::radius);
}

template <class V>
void visit_fields(V& v, Type<SegmentGeometry>) {
    v.field({"from", "One end.", "m", kCoordinate, true}, &SegmentGeometry::from);
    v.field({"to", "The other end.", "m", kCoordinate, true}, &SegmentGeometry::to);
}

template <class V>
void visit_fields(V& v, Type<ChainGeometry>) {
    v.field({"points",
             "Corners, one after the other. On the left of this direction is the inside, which things pass through "
             "unhindered: "
             "a ground to stand on goes from right to left, the inside of a bowl or room clockwise.",
             "m", kCoordinate, true, 2},
            &ChainGeometry::points);
    v.field({"loop", "Whether the last point is joined to the first."}, &ChainGeometry::loop);
    v.field({"two_sided", "Whether it is met from both sides, not only from the right of its direction."},
            &ChainGeometry::two_sided);
}

template <class V>
void visit_fields(V& v, Type<OutlineGeometry>) {
    v.field({"points", "Corners of a simple polygon, concave or not.", "m", kCoordinate, true, 3},
            &OutlineGeometry::points);
}

template <class V>
void visit_alternatives(V& v, Type<ShapeGeometry>) {
    v.template alternative<CircleGeometry>("circle", "A disc.");
    v.template alternative<CapsuleGeometry>("capsule", "A segment grown by a radius.");
    v.template alternative<BoxGeometry>("box", "A rectangle, rounded if it has a radius.");
    v.template alternative<PolygonGeometry>("polygon", "A convex polygon, rounded if it has a radius.");
    v.template alternative<SegmentGeometry>("segment", "A line that is solid on both sides and has no mass.");
    v.template alternative<ChainGeometry>("chain", "A line of segments, for grounds; it has no mass.");
    v.template alternative<OutlineGeometry>("outline", "A polygon that need not be convex.");
}

template <class V>
void visit_fields(V& v, Type<SceneFilter>) {
    v.field({"category", "Bits of what the shape is.", "", kBits}, &SceneFilter::category);
    v.field({"mask", "Bits of what it meets: each of two shapes must have one of the other's category.", "", kBits},
            &SceneFilter::mask);
    v.field({"group",
             "Of two shapes with the same one other than 0, this alone counts: positive ones meet, negative "
             "ones do not.",
             "",
             {-1e6, 1e6}},
            &SceneFilter::group);
}

template <class V>
void visit_fields(V& v, Type<SceneShape>) {
    v.one_of({.name = "shape", .description = "What the shape is."}, &SceneShape::geometry);
    v.field(
        {.name = "material", .description = "Name of a material; left out: the defaults of one.", .text = Text::name},
        &SceneShape::material);
    v.field({"filter", "Which shapes it meets."}, &SceneShape::filter);
    v.field({"sensor", "Only notices what overlaps it; has no mass."}, &SceneShape::sensor);
    v.json({"custom", "Anything a user wants to keep."}, &SceneShape::custom);
}

}  // namespace tumble::scene
