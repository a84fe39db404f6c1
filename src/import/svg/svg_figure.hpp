// The geometry of one SVG element, in world coordinates.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <variant>
#include <vector>

#include "import/svg/svg_flatten.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

// Width and height of the drawing in user units, which percentages refer to; NaN if the drawing does not state them.
struct SvgViewport {
    DVec2 size;
};

struct SvgFigure {
    std::vector<Contour> contours;  // curves as chords; none if the element draws nothing
    // The area without chords, centred at `position`: a circle or a box, if the transform keeps it one.
    std::optional<std::variant<CircleGeometry, BoxGeometry>> exact;
    DVec2 position;
};

// True for rect, circle, ellipse, line, polyline, polygon and path.
bool is_figure(std::string_view tag);

// Throws SvgError for attribute values that SVG defines as errors.
SvgFigure read_figure(const pugi::xml_node& element, const Affine& world_from_element, const SvgViewport& viewport,
                      double tolerance);

}  // namespace tumble::scene
