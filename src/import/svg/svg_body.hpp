// Makes a body from a figure and its style.
#pragma once

#include <map>
#include <string>

#include "import/svg/svg_figure.hpp"
#include "import/svg/svg_style.hpp"

namespace tumble::scene {

// Features that could not be carried over, with counts.
using SvgNotes = std::map<std::string, int>;

// The body of a figure: areas become a circle, boxes, polygons or outlines (several for an area with holes), lines
// become chains. The body has no shapes if all of them are degenerate or hidden, which the notes count. Materials are
// not set.
//
// A contour is an area if it is filled and closed, or filled without a stroke. A body is dynamic if it has an area and
// static otherwise, unless the style states a type. If the type is not static, a closed line becomes an area and an
// open line becomes capsules of its stroke width.
SceneBody make_svg_body(const SvgFigure& figure, const SvgStyle& style, double metres_per_stroke, SvgNotes& notes);

}  // namespace tumble::scene
