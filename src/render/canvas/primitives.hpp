// The primitives of a frame, grouped in layers. Coordinates are pixels from the middle of the frame, y up.
//
// Plain data in the layout in which the canvas uploads it. Building it needs no GL.
#pragma once

#include <array>
#include <vector>

#include "render/style/color.hpp"
#include "tumble/render.hpp"

namespace tumble::render {

struct CircleInstance {
    float x = 0.0f, y = 0.0f;
    float radius = 0.0f;
    Paint paint;
};

// A rectangle grown by a radius: boxes, capsules (half_y = 0), lines.
struct BoxInstance {
    float x = 0.0f, y = 0.0f;            // center
    float axis_x = 1.0f, axis_y = 0.0f;  // unit vector along the first side
    float half_x = 0.0f, half_y = 0.0f;  // of the core, without the radius
    float radius = 0.0f;
    Paint paint;
};

// A convex polygon of 3 to 8 vertices grown by a radius, in the frame of a rectangle tight around its core.
struct PolygonInstance {
    static constexpr std::size_t kVertices = 8;

    float x = 0.0f, y = 0.0f;            // center of the rectangle
    float axis_x = 1.0f, axis_y = 0.0f;  // unit vector along its first side
    float half_x = 0.0f, half_y = 0.0f;  // of the rectangle, without the radius
    float radius = 0.0f;
    std::array<float, 2 * kVertices> vertices{};  // x, y in turn; counter-clockwise, padded with vertex 0
    Paint paint;
};

// A corner of a triangle; `depth` is the signed distance to the shape's edge, negative inside.
struct MeshVertex {
    float x = 0.0f, y = 0.0f;
    float depth = 0.0f;
    Paint paint;
};

// A rectangle of the glyph atlas on whole pixels.
struct GlyphInstance {
    float x = 0.0f, y = 0.0f;           // lower left corner
    float width = 0.0f, height = 0.0f;  // pixels, of the frame and of the atlas alike
    float atlas_x = 0.0f, atlas_y = 0.0f;
    Color color;
};

// A picture in a rectangle, its first row at the top.
struct ImageInstance {
    float x = 0.0f, y = 0.0f;            // center
    float axis_x = 1.0f, axis_y = 0.0f;  // unit vector along the rows
    float half_x = 0.0f, half_y = 0.0f;
    float opacity = 1.0f;
    float mirror = 1.0f;            // -1: left and right are swapped
    const Image* pixels = nullptr;  // not empty; lives as long as the canvas
};

// Drawn in the order of the members: later kinds cover earlier ones.
struct Layer {
    std::vector<MeshVertex> mesh;  // three to a triangle
    std::vector<PolygonInstance> polygons;
    std::vector<PolygonInstance> rounded_polygons;
    std::vector<BoxInstance> boxes;
    std::vector<CircleInstance> circles;
    std::vector<ImageInstance> images;
    std::vector<GlyphInstance> glyphs;
    // Of all outlines in the layer (pixels). An outline lies inside its shape; those of joined parts straddle the edge.
    double outline_width = 0.0;

    void clear() {
        mesh.clear();
        polygons.clear();
        rounded_polygons.clear();
        boxes.clear();
        circles.clear();
        images.clear();
        glyphs.clear();
    }
};

// A frame, from the lowest layer to the topmost.
struct DrawList {
    Color background;
    Layer grid;
    Layer backdrop;  // images behind all bodies
    Layer ground;    // static bodies
    Layer hatching;  // over them
    Layer shadows;   // of all other bodies
    Layer sensors;   // of any body
    Layer bodies;    // kinematic and dynamic bodies
    Layer images;    // images in front of them
    Layer islands;   // bodies again, in the colours of their islands
    Layer details;   // orientation marks and joints
    Layer overlay;   // contacts, normals, boxes, velocities; markings
    Layer notes;
    Layer captions;
    Layer card;  // the title card

    std::array<Layer*, 14> layers() {
        return {&grid,   &backdrop, &ground,  &hatching, &shadows, &sensors,  &bodies,
                &images, &islands,  &details, &overlay,  &notes,   &captions, &card};
    }
    std::array<const Layer*, 14> layers() const {
        return {&grid,   &backdrop, &ground,  &hatching, &shadows, &sensors,  &bodies,
                &images, &islands,  &details, &overlay,  &notes,   &captions, &card};
    }
};

}  // namespace tumble::render
