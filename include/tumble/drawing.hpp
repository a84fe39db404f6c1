// Explanatory drawings: plots, diagrams of a distance query, worst cases of a parity run.
//
// A drawing is a list of lines, polygons, discs and texts. Coordinates are pixels from the upper left corner, y down. A
// drawing can be written as SVG (for pages and papers) or drawn as an image (by the canvas that draws the frames).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tumble/distance.hpp"
#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble {

// A colour of 8 bits per channel with straight alpha.
struct Color {
    std::uint8_t r = 0, g = 0, b = 0;
    std::uint8_t a = 255;

    friend constexpr bool operator==(Color, Color) = default;
};

inline constexpr Color kTransparent{0, 0, 0, 0};

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

// The elements are drawn over the background in the order of the list.
struct Drawing {
    int width = 0;
    int height = 0;
    Color background{255, 255, 255, 255};
    std::vector<DrawnElement> elements{};

    void line(DVec2 from, DVec2 to, double width_px, Color color);

    // `begun` is the length of the line before, whose dashes this one continues (px).
    void dashed_line(DVec2 from, DVec2 to, double width_px, Color color, double begun = 0.0);
    void arrow(DVec2 from, DVec2 to, double width_px, Color color);  // with its head at `to`
    void polyline(const std::vector<DVec2>& points, double width_px, Color color);
    void polygon(std::vector<DVec2> points, Color fill, double outline_width, Color outline);
    void disc(DVec2 center, double radius, Color fill, double outline_width = 0.0, Color outline = {});
    void text(DVec2 at, std::string text, double size, Color color, TextAnchor anchor = TextAnchor::left);
};

// The text with & < > and double quotes as entities, and control characters that XML lacks as question marks.
std::string escape_markup(std::string_view text);

// A standalone SVG document with numbers rounded to 1/100 px. The same drawing gives the same bytes.
std::string to_svg(const Drawing& drawing);

// Two panels: the shapes at their poses with the witness points of the result, and the contact enlarged. The rings mark
// further points of the world, such as the witness points of another engine.
Drawing draw_pair(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                  const DistanceResult& result, std::span<const DVec2> rings = {});

// The iterations of GJK: panels of the pair and of its Minkowski difference, then one panel per iteration with the
// simplex, its nearest point, the search direction and the support vertex, then a plot of both bounds.
Drawing draw_trace(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                   const DistanceTrace& trace);

}  // namespace tumble
