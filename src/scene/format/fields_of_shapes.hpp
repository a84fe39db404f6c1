// The scene fields of shapes: geometry, material, filter. Part of fields.hpp.
#pragma once

#include "scene/format/field.hpp"

namespace tumble::scene {

template <class V>
void visit_fields(V& v, Type<CircleGeometry>) {
    v.field({"radius", "Radius of the circle.", "m", kRadius, true}, &CircleGeometry::radius);
    v.field({"center", "Centre of the circle, in body coordinates.", "m", kCoordinate}, &CircleGeometry::center);
}

template <class V>
void visit_fields(V& v, Type<CapsuleGeometry>) {
    v.field({"from", "Centre of one round end, in body coordinates.", "m", kCoordinate, true}, &CapsuleGeometry::from);
    v.field({"to", "Centre of the other round end, in body coordinates.", "m", kCoordinate, true},
            &CapsuleGeometry::to);
    v.field({"radius", "Radius of the round ends: half the thickness.", "m", kRadius, true}, &CapsuleGeometry::radius);
}

template <class V>
void visit_fields(V& v, Type<BoxGeometry>) {
    v.field({"size", "Outer width and height, rounded corners included.", "m", kLength, true}, &BoxGeometry::size);
    v.field({"radius", "Radius of the rounded corners, at most half the shorter side.", "m", kRounding},
            &BoxGeometry::radius);
    v.field({"center", "Centre of the box, in body coordinates.", "m", kCoordinate}, &BoxGeometry::center);
    v.field({"angle", "Rotation about the centre of the box.", "degrees"}, &BoxGeometry::angle);
}

template <class V>
void visit_fields(V& v, Type<PolygonGeometry>) {
    v.field({"vertices", "Points in any order, in body coordinates. The polygon is their convex hull.", "m",
             kCoordinate, true, 3},
            &PolygonGeometry::vertices);
    v.field({"radius", "Radius by which the polygon grows on all sides, which rounds its corners.", "m", kRounding},
            &PolygonGeometry::radius);
}

template <class V>
void visit_fields(V& v, Type<SegmentGeometry>) {
    v.field({"from", "One end, in body coordinates.", "m", kCoordinate, true}, &SegmentGeometry::from);
    v.field({"to", "The other end, in body coordinates.", "m", kCoordinate, true}, &SegmentGeometry::to);
}

template <class V>
void visit_fields(V& v, Type<ChainGeometry>) {
    v.field({"points",
             "Points of the chain in order, in body coordinates. The left of this direction is solid: bodies collide "
             "with the chain from the right and pass through it from the left. List a floor from right to left, the "
             "inside of a bowl or a room clockwise, the outside of a block counter-clockwise.",
             "m", kCoordinate, true, 2},
            &ChainGeometry::points);
    v.field({"loop", "Whether a segment connects the last point to the first."}, &ChainGeometry::loop);
    v.field({"two_sided",
             "Whether bodies collide with the chain from both sides, not only from the right of its direction."},
            &ChainGeometry::two_sided);
}

template <class V>
void visit_fields(V& v, Type<OutlineGeometry>) {
    v.field(
        {"points", "Corners in order, in body coordinates, of a polygon that may be concave and does not cross itself.",
         "m", kCoordinate, true, 3},
        &OutlineGeometry::points);
}

template <class V>
void visit_alternatives(V& v, Type<ShapeGeometry>) {
    v.template alternative<CircleGeometry>("circle", "A disc.");
    v.template alternative<CapsuleGeometry>("capsule", "A segment with a radius: a bar with round ends.");
    v.template alternative<BoxGeometry>("box", "A rectangle, with rounded corners if it has a radius.");
    v.template alternative<PolygonGeometry>("polygon", "A convex polygon, with rounded corners if it has a radius.");
    v.template alternative<SegmentGeometry>("segment", "A line that is solid on both sides. It has no mass.");
    v.template alternative<ChainGeometry>("chain",
                                          "A line of connected segments, for ground and walls. It has no mass.");
    v.template alternative<OutlineGeometry>("outline", "A polygon that may be concave. It is split into convex parts.");
}

template <class V>
void visit_fields(V& v, Type<SceneFilter>) {
    v.field({"category", "Bits of the categories that the shape belongs to.", "", kBits}, &SceneFilter::category);
    v.field({"mask",
             "Bits of the categories that the shape collides with. Two shapes collide if the mask of each contains a "
             "category of the other.",
             "", kBits},
            &SceneFilter::mask);
    v.field({"group",
             "Two shapes with the same group other than 0 ignore categories and masks: they always collide if the "
             "group is positive, and never if it is negative.",
             "",
             {-1e6, 1e6}},
            &SceneFilter::group);
}

template <class V>
void visit_fields(V& v, Type<SceneShape>) {
    v.one_of({.name = "shape", .description = "Geometry of the shape."}, &SceneShape::geometry);
    v.field({.name = "material",
             .description = "Name of a material. Default: a material whose values are all defaults.",
             .text = Text::name},
            &SceneShape::material);
    v.field({"filter", "Which shapes the shape collides with. Default: all."}, &SceneShape::filter);
    v.field({"sensor", "Whether the shape only reports what overlaps it. A sensor has no mass and stops nothing."},
            &SceneShape::sensor);
    v.json({"custom", "Any JSON value: kept with the shape, without effect on the simulation."}, &SceneShape::custom);
}

}  // namespace tumble::scene
