#include "render/canvas/shaders.hpp"

namespace tumble::render {
namespace {

// `to_clip` scales pixels, counted from the middle of the frame, to clip space; `outline_width` is in pixels.
const std::string kVertexHead = R"(#version 330 core
uniform vec2 to_clip;
uniform float outline_width;

vec4 clip_position(vec2 pixel) { return vec4(pixel * to_clip, 0.0, 1.0); }
vec4 premultiplied(vec4 color) { return vec4(color.rgb * color.a, color.a); }
vec2 corner() { return vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0; }
)";

// An instance is drawn as the rectangle around it, grown by the half pixel over which its edge is blended. Small shapes
// have thinner outlines, so that their fill stays visible. Each pixel computes its point in the instance's coordinates:
// a value that the rasteriser interpolates over a thin rectangle differs between back ends.
const std::string kInstanceHead = kVertexHead + R"(
layout(location = 0) in vec4 fill;
layout(location = 1) in vec4 outline;
flat out vec4 placed;  // the center, counted from the lower left corner of the frame, and the axis
flat out vec4 fill_color;
flat out vec4 outline_color;
flat out float edge_width;

void paint(float smallest_half) {
    fill_color = premultiplied(fill);
    outline_color = premultiplied(outline);
    edge_width = min(outline_width, 0.3 * smallest_half);
}

void place(vec2 center, vec2 axis, vec2 half_size) {
    placed = vec4(center + 0.5 * round(2.0 / to_clip), axis);
    vec2 point = corner() * (half_size + 0.5);
    gl_Position = clip_position(center + point.x * axis + point.y * vec2(-axis.y, axis.x));
}
)";

const std::string kPainted = R"(
out vec4 color;

vec4 painted(float depth) {
    float inside = clamp(0.5 - depth - edge_width, 0.0, 1.0);
    return mix(outline_color, fill_color, inside) * clamp(0.5 - depth, 0.0, 1.0);
}
)";

const std::string kFragmentHead = R"(#version 330 core
flat in vec4 placed;
flat in vec4 fill_color;
flat in vec4 outline_color;
flat in float edge_width;

// The middle of the pixel, in the coordinates of the instance.
vec2 pixel_point() {
    vec2 offset = gl_FragCoord.xy - placed.xy, axis = placed.zw;
    return vec2(dot(offset, axis), dot(offset, vec2(-axis.y, axis.x)));
}
)" + kPainted;

const std::string kPolygonHead = kInstanceHead + R"(
layout(location = 2) in vec4 frame;  // center, axis
layout(location = 3) in vec3 size;   // half size of the core, radius
layout(location = 4) in vec4 v01;
layout(location = 5) in vec4 v23;
layout(location = 6) in vec4 v45;
layout(location = 7) in vec4 v67;
)";

}  // namespace

ShaderSource circle_shader() {
    return {"circle", kInstanceHead + R"(
layout(location = 2) in vec3 circle;
flat out float radius;

void main() {
    radius = circle.z;
    paint(radius);
    place(circle.xy, vec2(1.0, 0.0), vec2(radius));
}
)",
            kFragmentHead + R"(
flat in float radius;

void main() { color = painted(length(pixel_point()) - radius); }
)"};
}

ShaderSource box_shader() {
    return {"box", kInstanceHead + R"(
layout(location = 2) in vec4 frame;  // center, axis
layout(location = 3) in vec3 size;   // half size of the core, radius
flat out vec3 core;

void main() {
    core = size;
    vec2 half_size = size.xy + size.z;
    paint(min(half_size.x, half_size.y));
    place(frame.xy, frame.zw, half_size);
}
)",
            kFragmentHead + R"(
flat in vec3 core;

void main() {
    vec2 beyond = abs(pixel_point()) - core.xy;
    color = painted(length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - core.z);
}
)"};
}

// The depth in a convex polygon without a radius is the largest signed distance to the lines through its edges.
ShaderSource polygon_shader() {
    return {"polygon", kPolygonHead + R"(
flat out vec3 edge[8];  // unit normal, offset

void main() {
    paint(min(size.x, size.y));
    place(frame.xy, frame.zw, size.xy);
    vec2 v[8] = vec2[8](v01.xy, v01.zw, v23.xy, v23.zw, v45.xy, v45.zw, v67.xy, v67.zw);
    vec3 last = vec3(0.0);
    for (int i = 0; i < 8; ++i) {
        vec2 along = v[(i + 1) & 7] - v[i];
        float size_sq = dot(along, along);
        if (size_sq > 0.0) {  // else the padding behind the last vertex
            vec2 normal = vec2(along.y, -along.x) * inversesqrt(size_sq);
            last = vec3(normal, -dot(normal, v[i]));
        }
        edge[i] = last;
    }
}
)",
            kFragmentHead + R"(
flat in vec3 edge[8];

void main() {
    vec2 point = pixel_point();
    float depth = dot(edge[0].xy, point) + edge[0].z;
    for (int i = 1; i < 8; ++i) depth = max(depth, dot(edge[i].xy, point) + edge[i].z);
    color = painted(depth);
}
)"};
}

// A rounded polygon needs the true distance near its corners too: the least distance to its edges as segments.
ShaderSource rounded_polygon_shader() {
    return {"rounded polygon", kPolygonHead + R"(
flat out vec4 segment[8];  // a vertex, the edge from it
flat out float radius;

void main() {
    radius = size.z;
    paint(min(size.x, size.y) + radius);
    place(frame.xy, frame.zw, size.xy + radius);
    vec2 v[8] = vec2[8](v01.xy, v01.zw, v23.xy, v23.zw, v45.xy, v45.zw, v67.xy, v67.zw);
    for (int i = 0; i < 8; ++i) segment[i] = vec4(v[i], v[(i + 1) & 7] - v[i]);
}
)",
            kFragmentHead + R"(
flat in vec4 segment[8];
flat in float radius;

void main() {
    vec2 point = pixel_point();
    float distance_sq = 1e30;
    float outside = -1e30;
    for (int i = 0; i < 8; ++i) {
        vec2 along = segment[i].zw;
        vec2 offset = point - segment[i].xy;
        float fraction = clamp(dot(offset, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
        vec2 apart = offset - fraction * along;
        distance_sq = min(distance_sq, dot(apart, apart));
        outside = max(outside, offset.x * along.y - offset.y * along.x);
    }
    float distance = sqrt(distance_sq);
    color = painted((outside > 0.0 ? distance : -distance) - radius);
}
)"};
}

ShaderSource mesh_shader() {
    return {"mesh", kVertexHead + R"(
layout(location = 0) in vec4 fill;
layout(location = 1) in vec4 outline;
layout(location = 2) in vec3 vertex;  // position, depth
noperspective out vec4 fill_color;
noperspective out vec4 outline_color;
noperspective out float depth;
flat out float edge_width;

void main() {
    fill_color = premultiplied(fill);
    outline_color = premultiplied(outline);
    depth = vertex.z;
    edge_width = outline_width;
    gl_Position = clip_position(vertex.xy);
}
)",
            R"(#version 330 core
noperspective in vec4 fill_color;
noperspective in vec4 outline_color;
noperspective in float depth;
flat in float edge_width;
)" + kPainted + R"(
void main() { color = painted(depth); }
)"};
}

// The texels are premultiplied, so that transparent ones add no colour where they are mixed with their neighbours.
ShaderSource image_shader() {
    return {"image", kVertexHead + R"(
layout(location = 0) in vec4 frame;  // center, axis
layout(location = 1) in vec4 image;  // half size, opacity, mirror
noperspective out vec2 point;
flat out vec4 rectangle;

void main() {
    rectangle = image;
    point = corner() * (image.xy + 0.5);
    vec2 across = vec2(-frame.w, frame.z);
    gl_Position = clip_position(frame.xy + point.x * frame.zw + point.y * across);
}
)",
            R"(#version 330 core
uniform sampler2D texels;
noperspective in vec2 point;
flat in vec4 rectangle;
out vec4 color;

void main() {
    vec2 beyond = abs(point) - rectangle.xy;
    vec2 part = 0.5 + 0.5 * point / rectangle.xy * vec2(rectangle.w, -1.0);
    color = texture(texels, part) * rectangle.z * clamp(0.5 - max(beyond.x, beyond.y), 0.0, 1.0);
}
)"};
}

ShaderSource glyph_shader() {
    return {"glyph", kVertexHead + R"(
layout(location = 0) in vec4 ink;
layout(location = 1) in vec4 rectangle;  // lower left corner, size
layout(location = 2) in vec2 atlas_origin;
noperspective out vec2 texel;
flat out vec4 ink_color;

void main() {
    vec2 offset = 0.5 * (corner() + 1.0) * rectangle.zw;
    texel = atlas_origin + vec2(offset.x, rectangle.w - offset.y);  // the atlas has its top row first
    ink_color = premultiplied(ink);
    gl_Position = clip_position(rectangle.xy + offset);
}
)",
            R"(#version 330 core
uniform sampler2D atlas;
noperspective in vec2 texel;
flat in vec4 ink_color;
out vec4 color;

void main() { color = ink_color * texelFetch(atlas, ivec2(texel), 0).r; }
)"};
}

}  // namespace tumble::render
