// Explanatory drawings: plots, diagrams of a distance query, worst cases of a parity run.
//
// A drawing is a list of lines, polygons, discs and texts in pixels, y down, from the upper left corner. One drawing
// becomes an SVG text (for pages and papers) or an image (the same canvas that draws the frames).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tumble/color.hpp"
#include "tumble/distance.hpp"
#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble {

// A line with round ends; a width of 0 draws nothing.
struct DrawnLine {
    DVec2 from, to;
    double width = 1.0;
    Color color;
};

// A simple polygon, convex or not, filled and outlined.
struct DrawnPolygon {
    std::vector<DVec2> points;
    Color fill = kTransparent;
    double outline_width = 0.0;
    Color outline;
};

struct DrawnDisc {
    DVec2 center;
    double radius = 1.0;
    Color fill = kTransparent;
    double outline_width = 0.0;
    Color outline;
};

enum class TextAnchor : std::uint8_t { left, middle, right };

// One line of text; `at` is on its baseline, at the anchor.
struct DrawnText {
    DVec2 at;
    std::string text;  // UTF-8
    double size = 14.0;
    Color color;
    TextAnchor anchor = TextAnchor::left;
};

using DrawnElement = std::variant<DrawnLine, DrawnPolygon, DrawnDisc, DrawnText>;

// Drawn in the order of the list, over the background.
struct Drawing {
    int width = 0;
    int height = 0;
    Color background{255, 255, 255, 255};
    std::vector<DrawnElement> elements{};

    void line(DVec2 from, DVec2 to, double width_px, Color color);
    void dashed_line(DVec2 from, DVec2 to, double width_px, Color color);
    void arrow(DVec2 from, DVec2 to, double width_px, Color color);  // with its head at `to`
    void polyline(const std::vector<DVec2>& points, double width_px, Color color);
    void polygon(std::vector<DVec2> points, Color fill, double outline_width, Color outline);
    void disc(DVec2 center, double radius, Color fill, double outline_width = 0.0, Color outline = {});
    void text(DVec2 at, std::string text, double size, Color color, TextAnchor anchor = TextAnchor::left);
};

// Text made safe inside XML and HTML: & < > and quotes become entities, control characters question marks.
std::string escape_markup(std::string_view text);

// A standalone SVG document; its numbers are rounded to 1/100 px. The same drawing gives the same bytes.
std::string to_svg(const Drawing& drawing);

// The two shapes at their poses with the witness points of the result, beside a view of the contact; the rings mark
// other points of the world, such as another engine's witness points.
Drawing draw_pair(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                  const DistanceResult& result, std::span<const DVec2> rings = {});

// How GJK came to its answer: the pair, its Minkowski difference with the origin, one panel an iteration with the
// simplex, the nearest point, the search direction and the support vertex found, and the bounds closing in.
Drawing draw_trace(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                   const DistanceTrace& trace);

}  // namespace tumble
