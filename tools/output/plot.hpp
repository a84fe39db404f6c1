// Plots: points, lines and bars over two axes, as SVG or as a drawing.
//
// In a page (html.cpp), the plot takes its colours from variables, so that it follows the reader's light or dark
// scheme. Values that are not finite are left out, and a line is interrupted there. Whatever lies outside the axes is
// clipped.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tumble/drawing.hpp"
#include "tumble/math.hpp"

namespace tumble::tools {

// What a series shows; each has one colour on every page.
enum class Ink { tumble, second, box2d, exact, limit, violet, teal };

enum class Mark { points, line, dashed };

// A bar from (left, base) to (right, top), data coordinates.
struct PlotBar {
    double left = 0.0, right = 0.0, base = 0.0, top = 0.0;
};

struct PlotSeries {
    std::string name;  // in the legend; empty: not in the legend
    Ink ink = Ink::tumble;
    Mark mark = Mark::points;
    std::vector<DVec2> points{};
    std::vector<PlotBar> bars{};
};

struct PlotTick {
    double at = 0.0;
    std::string label;
};

struct PlotRange {
    double lower = 0.0, upper = 1.0;
};

struct PlotAxis {
    std::string label;
    bool logarithmic = false;          // values of 0 or less are left out
    std::optional<PlotRange> range{};  // default: that of the data, with a margin
    std::vector<PlotTick> ticks{};     // default: at round numbers
};

// The values of y between which a result passes, drawn as a band behind the series.
struct PlotBand {
    std::string name;
    double lower = 0.0, upper = 0.0;
};

struct Plot {
    std::string title;  // also what a screen reader says
    PlotAxis x, y;
    std::vector<PlotSeries> series;
    std::optional<PlotBand> band{};
    int width = 620;  // px
    int height = 330;
};

// Ticks of a linear axis at multiples of 1, 2 or 5 times a power of ten, at most `most` + 1 of them. A range that is
// too short for the digits of labels, or longer than a double, has one tick, at its lower end.
std::vector<PlotTick> round_ticks(PlotRange range, int most);

// Ticks of a logarithmic axis: at powers of ten, also at 2 and 5 times them if the range has less than two of them.
std::vector<PlotTick> decade_ticks(PlotRange range, int most);

// One <svg> element for a page of HtmlPage.
std::string to_svg(const Plot& plot);

// A standalone SVG document with the plots one below the other, in light colours. Any viewer shows it: it has no
// variables, scripts or fonts of its own.
std::string to_svg(std::span<const Plot> plots);

// The same picture as a drawing, for draw_image(). Texts of drawings are level: it has no labels of vertical axes, and
// no second labels of horizontal ones.
struct PlotPage {
    double least_left = 0.0;  // px: the areas between the axes begin at least here
    bool is_dark = false;     // in the colours of the dark scheme
};
Drawing to_drawing(std::span<const Plot> plots, PlotPage page = {});

}  // namespace tumble::tools
