#include "tools/output/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "tools/output/plot_colors.hpp"
#include "tools/output/plot_layout.hpp"
#include "tumble/drawing.hpp"

namespace tumble::tools {

namespace {

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f", value);
    return text.data();
}

std::string attribute(std::string_view name, double value) {
    return " " + std::string(name) + "=\"" + number(value) + "\"";
}

std::string class_of(Ink ink) { return std::string(plot_color(ink).name); }

std::string text_at(double x, double y, std::string_view anchor, std::string_view text) {
    return "<text" + attribute("x", x) + attribute("y", y) + " text-anchor=\"" + std::string(anchor) + "\">" +
           escape_markup(text) + "</text>\n";
}

std::string grid_line(double x1, double y1, double x2, double y2) {
    return "<line class=\"grid\"" + attribute("x1", x1) + attribute("y1", y1) + attribute("x2", x2) +
           attribute("y2", y2) + "/>\n";
}

std::string swatch_of(const LegendEntry& entry) {
    if (!entry.series) return R"(<rect class="band" x="0" y="-11" width="18" height="12"/>)";
    const PlotSeries& series = *entry.series;
    const std::string ink = class_of(series.ink);
    if (!series.bars.empty()) return "<rect class=\"bar " + ink + "\" x=\"2\" y=\"-10\" width=\"12\" height=\"10\"/>";
    if (series.mark == Mark::points) return "<circle class=\"point " + ink + "\" cx=\"9\" cy=\"-4\" r=\"3.5\"/>";
    return "<line class=\"line " + ink + (series.mark == Mark::dashed ? " dashed" : "") +
           "\" x1=\"0\" y1=\"-4\" x2=\"18\" y2=\"-4\"/>";
}

// Writes the parts of a plot where the layout has them.
class SvgPlot {
public:
    explicit SvgPlot(const Plot& plot, double least_left = 0.0) : plot_(plot), layout_(plot, least_left) {}
    std::string text(std::string_view place) const;

private:
    double x(double value) const { return layout_.x(value); }
    double y(double value) const { return layout_.y(value); }
    std::string heading() const;
    std::string legend() const;
    std::string axes() const;
    std::string band() const;
    std::string series() const;
    std::string bars(const PlotSeries& series) const;
    std::string points(const PlotSeries& series) const;
    std::string lines(const PlotSeries& series) const;

    const Plot& plot_;
    PlotLayout layout_;
};

std::string SvgPlot::heading() const {
    std::string text;
    for (std::size_t line = 0; line < layout_.title.size(); ++line)
        text +=
            text_at(12.0, kFirstHeadingBase + kHeadingLine * static_cast<double>(line), "start", layout_.title[line]);
    return "<g class=\"heading\">" + text + "</g>\n";
}

std::string SvgPlot::legend() const {
    std::string text;
    for (const LegendEntry& entry : layout_.legend)
        text += "<g transform=\"translate(" + number(entry.at.x) + " " + number(entry.at.y) + ")\">" +
                swatch_of(entry) + text_at(24.0, 0.0, "start", entry.name) + "</g>\n";
    return text;
}

std::string SvgPlot::axes() const {
    std::string text;
    for (const PlotTick& tick : layout_.x_scale.ticks) {
        text += grid_line(x(tick.at), layout_.top, x(tick.at), layout_.bottom);
        text += text_at(x(tick.at), layout_.bottom + 17.0, "middle", tick.label);
        if (layout_.has_upper_labels) text += text_at(x(tick.at), layout_.top - 7.0, "middle", tick.label);
    }
    for (const PlotTick& tick : layout_.y_scale.ticks) {
        text += grid_line(layout_.left, y(tick.at), layout_.right, y(tick.at));
        text += text_at(layout_.left - 7.0, y(tick.at) + 4.0, "end", tick.label);
    }
    text += text_at(0.5 * (layout_.left + layout_.right), layout_.bottom + 38.0, "middle", plot_.x.label);
    if (!plot_.y.label.empty())
        text += "<g transform=\"translate(16 " + number(0.5 * (layout_.top + layout_.bottom)) + ") rotate(-90)\">" +
                text_at(0.0, 0.0, "middle", plot_.y.label) + "</g>\n";
    return text + "<rect class=\"frame\"" + attribute("x", layout_.left) + attribute("y", layout_.top) +
           attribute("width", layout_.right - layout_.left) + attribute("height", layout_.bottom - layout_.top) +
           "/>\n";
}

std::string SvgPlot::band() const {
    if (!plot_.band) return "";
    const PlotRange band = layout_.band();
    return "<rect class=\"band\"" + attribute("x", layout_.left) + attribute("y", band.lower) +
           attribute("width", layout_.right - layout_.left) + attribute("height", band.upper - band.lower) + "/>\n";
}

std::string SvgPlot::bars(const PlotSeries& series) const {
    std::string text;
    for (const PlotBar& bar : series.bars) {
        const double from = std::min(y(bar.base), y(bar.top)), size = std::abs(y(bar.base) - y(bar.top));
        text += "<rect class=\"bar " + class_of(series.ink) + "\"" + attribute("x", x(bar.left)) +
                attribute("y", from) + attribute("width", x(bar.right) - x(bar.left)) + attribute("height", size) +
                "/>\n";
    }
    return text;
}

std::string SvgPlot::points(const PlotSeries& series) const {
    std::string text;
    for (const DVec2 point : series.points)
        if (layout_.shows(point))
            text += "<circle class=\"point " + class_of(series.ink) + "\"" + attribute("cx", x(point.x)) +
                    attribute("cy", y(point.y)) + " r=\"3\"/>\n";
    return text;
}

std::string SvgPlot::lines(const PlotSeries& series) const {
    std::string path;
    for (const std::vector<DVec2>& line : layout_.lines(series))
        for (std::size_t i = 0; i < line.size(); ++i)
            path += (i == 0 ? "M" : "L") + number(line[i].x) + " " + number(line[i].y);
    const std::string dashed = series.mark == Mark::dashed ? " dashed" : "";
    return "<path class=\"line " + class_of(series.ink) + dashed + "\" d=\"" + path + "\"/>\n";
}

// Curves and bars, in an <svg> element of the size of the axes, so that no part is drawn outside them.
std::string SvgPlot::series() const {
    const std::string box = number(layout_.left) + " " + number(layout_.top) + " " +
                            number(layout_.right - layout_.left) + " " + number(layout_.bottom - layout_.top);
    std::string text = "<svg" + attribute("x", layout_.left) + attribute("y", layout_.top) +
                       attribute("width", layout_.right - layout_.left) +
                       attribute("height", layout_.bottom - layout_.top) + " viewBox=\"" + box + "\">\n" + band();
    for (const PlotSeries& one : plot_.series) {
        text += bars(one);
        if (one.points.empty()) continue;
        text += one.mark == Mark::points ? points(one) : lines(one);
    }
    return text + "</svg>\n";
}

// `place` are further attributes of the element.
std::string SvgPlot::text(std::string_view place) const {
    const std::string width = std::to_string(plot_.width), height = std::to_string(plot_.height);
    return "<svg class=\"plot\" role=\"img\" viewBox=\"0 0 " + width + " " + height + "\" width=\"" + width +
           "\" height=\"" + height + "\"" + std::string(place) + ">\n<title>" + escape_markup(plot_.title) +
           "</title>\n" + heading() + legend() + axes() + series() + "</svg>\n";
}

}  // namespace

std::string to_svg(const Plot& plot) { return SvgPlot(plot).text(""); }

std::string to_svg(std::span<const Plot> plots) {
    const double left = common_left(plots);
    int width = 0, height = 0;
    std::string text;
    for (const Plot& plot : plots) {
        text += SvgPlot(plot, left).text(attribute("y", height));
        width = std::max(width, plot.width);
        height += plot.height;
    }
    const std::string sides = " width=\"" + std::to_string(width) + "\" height=\"" + std::to_string(height) + "\"";
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + std::to_string(width) + " " +
           std::to_string(height) + "\"" + sides + ">\n<style>\n" + plot_style(Scheme::fixed) + "</style>\n<rect" +
           sides + " fill=\"#fff\"/>\n" + text + "</svg>\n";
}

}  // namespace tumble::tools
