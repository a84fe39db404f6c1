// The GLSL of the canvas: one program for each kind of primitive.
//
// A fragment's colour follows from its signed distance to the shape's edge, in pixels (negative inside): half a pixel
// on either side of the edge is blended, and likewise where outline and fill meet. One program that branches over all
// kinds takes twice the time on a software rasteriser.
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
ShaderSource glyph_shader();

}  // namespace tumble::render
