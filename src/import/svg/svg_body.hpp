// From a figure and its style to a body.
#pragma once

#include <map>
#include <string>

#include "import/svg/svg_figure.hpp"
#include "import/svg/svg_style.hpp"

namespace tumble::scene {

// What could not be carried over, by name.
using SvgNotes = std::map<std::string, int>;

// The body of a figure: its areas as a circle, boxes, polygons or outlines, its lines as chains. Without shapes if
// nothing of it is left, which the notes say. Materials are left out.
//
// A contour is an area if it is filled and closed, or filled without a stroke. A body is dynamic if it has an area,
// else static, unless the style asks for a type. A closed line that shall move becomes an area, an open one capsules of
// its stroke width.
SceneBody make_svg_body(const SvgFigure& figure, const SvgStyle& style, double metres_per_stroke, SvgNotes& notes);

}  // namespace tumble::scene
