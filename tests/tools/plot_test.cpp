// Plots: round ticks, mapping of values to pixels, colours by class, and what is left out.
#include "tools/output/plot.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <regex>
#include <string>
#include <variant>
#include <vector>

#include "support/near.hpp"

using namespace tumble;
using namespace tumble::test;
using namespace tumble::tools;

namespace {

std::vector<std::string> labels(const std::vector<PlotTick>& ticks) {
    std::vector<std::string> all;
    for (const PlotTick& tick : ticks) all.push_back(tick.label);
    return all;
}

// The numbers of an attribute in the order of the elements: "cx" of the circles with a class.
std::vector<double> attributes(const std::string& svg, const std::string& tag, const std::string& name) {
    std::vector<double> values;
    const std::regex pattern("<" + tag + "[^>]* " + name + "=\"([-0-9.]+)\"");
    for (std::sregex_iterator found(svg.begin(), svg.end(), pattern), end; found != end; ++found)
        values.push_back(std::stod((*found)[1]));
    return values;
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

Plot points_of(std::vector<DVec2> points) {
    Plot plot{.title = "a < b", .x = {.label = "time, s"}, .y = {.label = "height, m"}, .series = {}};
    plot.series.push_back({.name = "", .points = std::move(points)});
    return plot;
}

}  // namespace

TEST_CASE("ticks are multiples of 1, 2 or 5 times a power of ten") {
    CHECK(labels(round_ticks({0.0, 1.0}, 5)) == std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1"});
    CHECK(labels(round_ticks({-0.3, 0.7}, 4)) == std::vector<std::string>{"0", "0.5"});
    CHECK(labels(round_ticks({3.19, 4.72}, 4)) == std::vector<std::string>{"3.5", "4", "4.5"});
    CHECK(labels(round_ticks({60.0, 60.0}, 4)) == std::vector<std::string>{"60"});
    CHECK(labels(round_ticks({1e16, 1e16 + 2.0}, 4)) == std::vector<std::string>{"1e16"});
    CHECK(labels(round_ticks({-1e308, 1e308}, 4)).size() == 1);
    CHECK(labels(round_ticks({0.0, 2.4e7}, 3)) == std::vector<std::string>{"0", "1e7", "2e7"});
    for (const double size : {1e-9, 0.3, 1.0, 7.0, 99.0, 12345.0})
        for (const int most : {2, 5, 9}) {
            const std::size_t found = round_ticks({0.1 * size, 1.1 * size}, most).size();
            CHECK(found <= static_cast<std::size_t>(most) + 1);
            CHECK(found >= static_cast<std::size_t>(most) / 3);
        }
}

TEST_CASE("ticks of a logarithmic axis are decades, or parts of one") {
    CHECK(labels(decade_ticks({1e-3, 100.0}, 8)) == std::vector<std::string>{"0.001", "0.01", "0.1", "1", "10", "100"});
    CHECK(labels(decade_ticks({1e-9, 1.0}, 3)) == std::vector<std::string>{"1e-9", "1e-6", "0.001", "1"});
    CHECK(labels(decade_ticks({15.0, 90.0}, 8)) == std::vector<std::string>{"20", "50"});
}

TEST_CASE("values are mapped linearly between the ends of the axes, upwards") {
    Plot plot = points_of({{0.0, 0.0}, {1.0, 5.0}, {4.0, 10.0}});
    plot.x.range = PlotRange{0.0, 4.0};
    plot.y.range = PlotRange{0.0, 10.0};
    const std::string svg = to_svg(plot);
    const std::vector<double> x = attributes(svg, "circle", "cx"), y = attributes(svg, "circle", "cy");
    REQUIRE(x.size() == 3);
    CHECK(near(x[1] - x[0], 0.25 * (x[2] - x[0]), absolute(0.02)));  // rounded to 1/100 px
    CHECK(near(y[1] - y[0], 0.5 * (y[2] - y[0]), absolute(0.02)));
    CHECK(x[2] > x[0] + 400.0);
    CHECK(y[2] < y[0] - 150.0);
}

TEST_CASE("equal factors are equal lengths on a logarithmic axis") {
    Plot plot = points_of({{1.0, 1.0}, {10.0, 1.0}, {100.0, 1.0}, {0.0, 1.0}, {-1.0, 1.0}});
    plot.x.logarithmic = true;
    const std::vector<double> x = attributes(to_svg(plot), "circle", "cx");
    REQUIRE(x.size() == 3);  // 0 and -1 have no logarithm
    CHECK(near(x[1] - x[0], x[2] - x[1], absolute(0.02)));
    CHECK(x[1] > x[0]);
}

TEST_CASE("a value that is not finite interrupts a line and is no point") {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    Plot plot = points_of({{0.0, 1.0}, {1.0, 2.0}, {2.0, kNan}, {3.0, 2.0}, {4.0, HUGE_VAL}, {5.0, 1.0}});
    CHECK(count(to_svg(plot), "<circle") == 4);
    plot.series.front().mark = Mark::line;
    const std::string svg = to_svg(plot);
    CHECK(count(svg, "nan") + count(svg, "inf") == 0);
    const std::string path = svg.substr(svg.find("<path"), svg.find("/>", svg.find("<path")) - svg.find("<path"));
    CHECK(count(path, "M") == 3);
    CHECK(count(path, "L") == 1);
}

TEST_CASE("a plot without values, or with a single one, has axes") {
    for (const std::vector<DVec2>& points : {std::vector<DVec2>{}, std::vector<DVec2>{{1.0, 0.0}}})
        for (const bool logarithmic : {false, true}) {
            Plot plot = points_of(points);
            plot.x.logarithmic = plot.y.logarithmic = logarithmic;
            const std::string svg = to_svg(plot);
            CHECK(count(svg, "nan") + count(svg, "inf") == 0);
            CHECK(count(svg, "class=\"grid\"") >= 2);
        }
}

TEST_CASE("the dashes of a drawn line continue behind a part that is far outside the axes") {
    Plot plot = points_of({{0.0, 0.5}, {0.4, 0.5}, {0.5, 1e300}, {0.6, 0.5}, {1.0, 0.5}});
    plot.series.front().mark = Mark::dashed;
    plot.y.range = PlotRange{0.0, 1.0};
    double longest = 0.0, behind = 0.0;
    const Drawing drawing = to_drawing({&plot, 1}, {});
    for (const DrawnElement& element : drawing.elements) {
        const DrawnLine* const line = std::get_if<DrawnLine>(&element);
        if (line == nullptr || line->width != 1.8) continue;
        longest = std::max(longest, length(line->to - line->from));
        if (line->from.x > 0.7 * drawing.width) behind += length(line->to - line->from);
    }
    CHECK(longest < 7.0);  // a dash has 6 px
    CHECK(behind > 40.0);
}

TEST_CASE("a plot has a title for screen readers, a legend, classes for colours, and escaped text") {
    Plot plot = points_of({{0.0, 1.0}, {1.0, 2.0}});
    plot.series.front().name = "tumble & co";
    plot.series.push_back({.name = "Box2D", .ink = Ink::box2d, .mark = Mark::dashed, .points = {{0.0, 1.0}}});
    plot.series.push_back({.name = "counts", .ink = Ink::limit, .bars = {{0.0, 1.0, 0.0, 2.0}}});
    plot.band = PlotBand{.name = "passes", .lower = 1.0, .upper = 1.5};
    const std::string svg = to_svg(plot);
    CHECK(svg.find("<svg class=\"plot\" role=\"img\"") == 0);
    CHECK(svg.find("<title>a &lt; b</title>") != std::string::npos);
    for (const char* text : {">tumble &amp; co<", ">Box2D<", ">counts<", ">passes<", ">time, s<", ">height, m<"})
        CHECK_MESSAGE(svg.find(text) != std::string::npos, text);
    for (const char* with_class : {"point tumble", "line box2d dashed", "bar limit", "class=\"band\""})
        CHECK_MESSAGE(svg.find(with_class) != std::string::npos, with_class);
    CHECK(svg.find('#') == std::string::npos);  // the page decides the colours
}

TEST_CASE("a bar covers its part of the axes whether it points up or down") {
    Plot plot = points_of({});
    plot.x.range = plot.y.range = PlotRange{0.0, 2.0};
    plot.series.front().bars = {{0.0, 1.0, 1.0, 2.0}, {1.0, 2.0, 1.0, 0.5}};
    const std::string svg = to_svg(plot);
    const std::string bars = svg.substr(svg.find("<rect class=\"bar"));
    const std::vector<double> y = attributes(bars, "rect", "y"), heights = attributes(bars, "rect", "height");
    REQUIRE(heights.size() == 2);
    CHECK(near(heights[0], 2.0 * heights[1], absolute(0.02)));
    CHECK(near(y[0] + heights[0], y[1], absolute(0.02)));
}

TEST_CASE("a long title is broken into lines") {
    Plot plot = points_of({{0.0, 1.0}});
    const std::size_t lines = count(to_svg(plot), "<text");
    plot.title = "a title that is longer than the plot is wide, and therefore stands in two lines above the legend";
    CHECK(count(to_svg(plot), "<text") == lines + 1);
}

TEST_CASE("plots one below the other have their vertical axes one below the other, in SVG and as a drawing") {
    Plot low = points_of({{0.0, 0.0}, {1.0, 0.5}}), high = points_of({{0.0, 0.0}, {1.0, 123456.0}});
    for (Plot* const plot : {&low, &high}) plot->series.front().mark = Mark::line, plot->y.label.clear();
    const std::vector<Plot> plots{low, high};
    const std::string svg = to_svg(plots);
    CHECK(svg.starts_with("<svg xmlns="));
    CHECK(count(svg, "var(") == 0);
    const std::vector<double> frames = attributes(svg, "rect class=\"frame\"", "x");
    REQUIRE(frames.size() == 2);
    CHECK(frames[0] == frames[1]);
    const Drawing drawing = to_drawing(plots);
    CHECK(drawing.width == 620);
    CHECK(drawing.height == 660);
    std::vector<double> lefts;
    for (const DrawnElement& element : drawing.elements)
        if (const auto* polygon = std::get_if<DrawnPolygon>(&element)) lefts.push_back(polygon->points.front().x);
    REQUIRE(lefts.size() == 2);
    CHECK(near(lefts[0], frames[0], absolute(0.01)));
    CHECK(lefts[1] == lefts[0]);
}

TEST_CASE("a drawing of a plot has the lines of its SVG, and none outside the axes") {
    Plot plot = points_of({{0.0, 0.0}, {1.0, 1.0}, {2.0, -1.0}});
    plot.series.front().mark = Mark::line;
    plot.x.range = PlotRange{0.0, 1.5};  // half of the second line is outside
    plot.y.range = PlotRange{-1.0, 1.0};
    const Drawing drawing = to_drawing(std::vector<Plot>{plot});
    std::vector<DrawnLine> lines;
    double right = 0.0;
    for (const DrawnElement& element : drawing.elements) {
        if (const auto* line = std::get_if<DrawnLine>(&element); line && line->width > 1.5) lines.push_back(*line);
        if (const auto* box = std::get_if<DrawnPolygon>(&element)) right = box->points[1].x;
    }
    // The legend is empty: the two segments alone. The second ends in the middle of its fall, at the right edge.
    REQUIRE(lines.size() == 2);
    CHECK(near(lines[1].to.x, right, absolute(0.01)));
    CHECK(near(lines[1].to.y, lines[0].from.y, absolute(0.01)));  // at a value of 0
    CHECK(lines[0].to.y < lines[0].from.y);
}

TEST_CASE("a line of many points keeps the extremes of each column of pixels") {
    std::vector<DVec2> points;
    for (int i = 0; i < 100000; ++i) points.push_back({0.001 * i, i == 54321 ? 7.0 : i == 12345 ? -3.0 : 0.0});
    Plot plot = points_of(points);
    plot.series.front().mark = Mark::line;
    plot.y.range = PlotRange{-3.0, 7.0};
    const std::string svg = to_svg(plot);
    CHECK(svg.size() < 100000u);
    const double y = attributes(svg, "rect class=\"frame\"", "y").front();
    const double height = attributes(svg, "rect class=\"frame\"", "height").front();
    std::array<char, 32> high{}, low{};
    std::snprintf(high.data(), high.size(), " %.2fL", y);
    std::snprintf(low.data(), low.size(), " %.2fL", y + height);
    CHECK(count(svg, high.data()) == 1);
    CHECK(count(svg, low.data()) == 1);
}
