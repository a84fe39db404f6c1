// The page of a drawing: its size, and what a unit of its coordinates is.
#pragma once

#include <pugixml.hpp>

#include "tumble/math.hpp"

namespace tumble::scene {

// Width and height are the size of the page, in pixels of 1/96 inch or in other units of length; the viewBox is the
// part of the plane that the page shows. Without width and height a user unit is a pixel. A page of other proportions
// than the viewBox shows it without distortion, unless preserveAspectRatio is "none".
struct SvgPage {
    DVec2 corner;                     // of the least coordinates, user units
    DVec2 size;                       // user units; NaN if the drawing does not state it
    DVec2 pixels_per_unit{1.0, 1.0};  // along each axis
};

// `root` is the <svg> element of the drawing. Throws SvgError for a value that is not a length.
SvgPage read_svg_page(const pugi::xml_node& root);

}  // namespace tumble::scene
