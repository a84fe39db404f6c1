// The geometry of one SVG element, in the world.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <variant>
#include <vector>

#include "import/svg/svg_flatten.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

// Width and height of the drawing in user units: NaN if it does not say. Percentages are of them.
struct SvgViewport {
    DVec2 size;
};

struct SvgFigure {
    std::vector<Contour> contours;  // curves as chords; none if the element draws nothing
    // What the area is without chords, about its own middle at the position: a circle or a box that the transform
    // left one.
    std::optional<std::variant<CircleGeometry, BoxGeometry>> exact;
    DVec2 position;
};

// True for rect, circle, ellipse, line, polyline, polygon and path.
bool is_figure(std::string_view tag);

// Throws SvgError for attributes that SVG calls an error.
SvgFigure read_figure(const pugi::xml_node& element, const Affine& world_from_element, const SvgViewport& viewport,
                      double tolerance);

}  // namespace tumble::scene
