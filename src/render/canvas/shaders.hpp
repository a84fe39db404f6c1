// The GLSL of the canvas: one program for each kind of primitive.
//
// The colour of a fragment is a function of its signed distance to the shape's edge in pixels (negative inside). Half a
// pixel on either side of the edge is blended, and likewise between outline and fill. A single program that branches
// over all kinds takes twice the time on a software rasteriser.
#pragma once

#include <string>

namespace tumble::render {

struct ShaderSource {
    const char* name;  // for error messages
    std::string vertex;
    std::string fragment;
};

ShaderSource circle_shader();
ShaderSource box_shader();
ShaderSource polygon_shader();
ShaderSource rounded_polygon_shader();
ShaderSource mesh_shader();
ShaderSource image_shader();
ShaderSource glyph_shader();

}  // namespace tumble::render
