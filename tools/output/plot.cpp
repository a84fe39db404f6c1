#include "tools/output/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>
#include <string_view>

#include "tumble/drawing.hpp"

namespace tumble::tools {

namespace {

constexpr double kCharacter = 7.2;  // px, the width of an average character of that size
constexpr double kHeadingCharacter = 8.6;
constexpr double kHeadingLine = 17.0;
constexpr double kLegendRow = 20.0;    // px
constexpr int kTall = 700;             // px, above which the horizontal axis has labels at both ends
constexpr double kTickSpacing = 42.0;  // px between ticks of the vertical axis, at least

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f", value);
    return text.data();
}

std::string attribute(std::string_view name, double value) {
    return " " + std::string(name) + "=\"" + number(value) + "\"";
}

std::string_view ink_class(Ink ink) {
    constexpr std::array<std::string_view, 5> kClasses = {"tumble", "second", "box2d", "exact", "limit"};
    return kClasses[static_cast<std::size_t>(ink)];
}

std::string text_at(double x, double y, std::string_view anchor, std::string_view text) {
    return "<text" + attribute("x", x) + attribute("y", y) + " text-anchor=\"" + std::string(anchor) + "\">" +
           escape_markup(text) + "</text>\n";
}

std::string grid_line(double x1, double y1, double x2, double y2) {
    return "<line class=\"grid\"" + attribute("x1", x1) + attribute("y1", y1) + attribute("x2", x2) +
           attribute("y2", y2) + "/>\n";
}

// An axis with its range and ticks decided: maps values to a part of its length, 0 to 1.
struct Scale {
    bool logarithmic = false;
    double lower = 0.0, upper = 1.0;  // logarithms to base 10 on a logarithmic axis
    std::vector<PlotTick> ticks;

    double transformed(double value) const { return logarithmic ? std::log10(value) : value; }
    bool shows(double value) const { return std::isfinite(value) && (!logarithmic || value > 0.0); }
    double part(double value) const { return (transformed(value) - lower) / (upper - lower); }
};

struct Extremes {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -std::numeric_limits<double>::infinity();
    void include(double value, bool logarithmic) {
        if (!std::isfinite(value) || (logarithmic && value <= 0.0)) return;
        lower = std::min(lower, value);
        upper = std::max(upper, value);
    }
};

// The range of the data with a margin of 6 %, or about a single value.
PlotRange padded(Extremes extremes, bool logarithmic, bool has_margin) {
    if (extremes.lower > extremes.upper) return logarithmic ? PlotRange{0.1, 10.0} : PlotRange{0.0, 1.0};
    const bool single = extremes.lower == extremes.upper;
    if (logarithmic) {
        const double factor = single ? 10.0 : has_margin ? std::pow(extremes.upper / extremes.lower, 0.06) : 1.0;
        return {extremes.lower / factor, extremes.upper * factor};
    }
    const double size = extremes.upper - extremes.lower;
    const double margin = single ? std::max(0.1 * std::abs(extremes.lower), 1e-9) : has_margin ? 0.06 * size : 0.0;
    return {extremes.lower - margin, extremes.upper + margin};
}

Scale scale_of(const PlotAxis& axis, Extremes extremes, int most_ticks, bool has_margin) {
    const PlotRange range = axis.range ? *axis.range : padded(extremes, axis.logarithmic, has_margin);
    Scale scale;
    scale.logarithmic = axis.logarithmic;
    scale.lower = scale.transformed(range.lower);
    scale.upper = scale.transformed(range.upper);
    scale.ticks = axis.ticks;
    if (scale.ticks.empty())
        scale.ticks = axis.logarithmic ? decade_ticks(range, most_ticks) : round_ticks(range, most_ticks);
    return scale;
}

// Those of one coordinate of all points, and of the two sides of bars along it.
Extremes extremes_of(const Plot& plot, const PlotAxis& axis, double DVec2::*coordinate, double PlotBar::*low,
                     double PlotBar::*high) {
    Extremes extremes;
    for (const PlotSeries& series : plot.series) {
        for (const DVec2 point : series.points) extremes.include(point.*coordinate, axis.logarithmic);
        for (const PlotBar& bar : series.bars) {
            extremes.include(bar.*low, axis.logarithmic);
            extremes.include(bar.*high, axis.logarithmic);
        }
    }
    return extremes;
}

Extremes extremes_of_x(const Plot& plot) {
    return extremes_of(plot, plot.x, &DVec2::x, &PlotBar::left, &PlotBar::right);
}

Extremes extremes_of_y(const Plot& plot) {
    Extremes extremes = extremes_of(plot, plot.y, &DVec2::y, &PlotBar::base, &PlotBar::top);
    if (plot.band) {
        extremes.include(plot.band->lower, plot.y.logarithmic);
        extremes.include(plot.band->upper, plot.y.logarithmic);
    }
    return extremes;
}

// The text broken between words into lines of at most `most` characters, where the words allow it.
std::vector<std::string> lines_of(const std::string& text, std::size_t most) {
    std::vector<std::string> lines(1);
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (!lines.back().empty() && lines.back().size() + 1 + word.size() > most) lines.emplace_back();
        lines.back() += (lines.back().empty() ? "" : " ") + word;
    }
    return lines;
}

// One entry of the legend. Its swatch looks as the series does.
struct LegendEntry {
    std::string name, swatch;
    double width() const { return 34.0 + kCharacter * static_cast<double>(name.size()); }
};

std::string swatch_of(const PlotSeries& series) {
    const std::string ink(ink_class(series.ink));
    if (!series.bars.empty()) return "<rect class=\"bar " + ink + "\" x=\"2\" y=\"-10\" width=\"12\" height=\"10\"/>";
    if (series.mark == Mark::points) return "<circle class=\"point " + ink + "\" cx=\"9\" cy=\"-4\" r=\"3.5\"/>";
    return "<line class=\"line " + ink + (series.mark == Mark::dashed ? " dashed" : "") +
           "\" x1=\"0\" y1=\"-4\" x2=\"18\" y2=\"-4\"/>";
}

std::vector<LegendEntry> legend_of(const Plot& plot) {
    std::vector<LegendEntry> entries;
    for (const PlotSeries& series : plot.series)
        if (!series.name.empty()) entries.push_back({series.name, swatch_of(series)});
    if (plot.band) entries.push_back({plot.band->name, R"(<rect class="band" x="0" y="-11" width="18" height="12"/>)"});
    return entries;
}

// Draws into the area between the axes, whose corners are known once the labels are laid out.
class Canvas {
public:
    explicit Canvas(const Plot& plot);
    std::string draw() const;

private:
    double x(double value) const { return left_ + (right_ - left_) * x_.part(value); }
    double y(double value) const { return bottom_ - (bottom_ - top_) * y_.part(value); }
    std::string heading() const;
    std::string legend() const;
    std::string axes() const;
    std::string band() const;
    std::string series() const;
    std::string bars(const PlotSeries& series) const;
    std::string points(const PlotSeries& series) const;
    std::string lines(const PlotSeries& series) const;
    double heading_height() const { return 34.0 + kHeadingLine * static_cast<double>(title_.size() - 1); }
    bool shows(DVec2 point) const { return x_.shows(point.x) && y_.shows(point.y); }

    const Plot& plot_;
    std::vector<std::string> title_;  // its lines
    std::vector<LegendEntry> legend_;
    double left_, right_, top_, bottom_;  // px
    Scale x_, y_;
};

Canvas::Canvas(const Plot& plot)
    : plot_(plot),
      title_(lines_of(plot.title, static_cast<std::size_t>((plot.width - 24.0) / kHeadingCharacter))),
      legend_(legend_of(plot)),
      left_(0.0),
      right_(plot.width - 18.0) {
    double end = 0.0;
    int rows = legend_.empty() ? 0 : 1;
    for (const LegendEntry& entry : legend_) {
        if (end > 0.0 && end + entry.width() > plot.width - 20.0) end = 0.0, ++rows;
        end += entry.width();
    }
    top_ = heading_height() + kLegendRow * rows + (plot.height > kTall ? kLegendRow : 0.0);
    bottom_ = plot.height - (plot.x.label.empty() ? 28.0 : 48.0);
    y_ = scale_of(plot.y, extremes_of_y(plot), std::max(2, static_cast<int>((bottom_ - top_) / kTickSpacing)), true);
    std::size_t longest = 0;
    for (const PlotTick& tick : y_.ticks) longest = std::max(longest, tick.label.size());
    left_ = (plot.y.label.empty() ? 14.0 : 34.0) + kCharacter * static_cast<double>(longest);
    const bool has_bars = std::ranges::any_of(plot.series, [](const PlotSeries& s) { return !s.bars.empty(); });
    x_ = scale_of(plot.x, extremes_of_x(plot), std::max(2, static_cast<int>((right_ - left_) / 80.0)), !has_bars);
}

std::string Canvas::heading() const {
    std::string text;
    for (std::size_t line = 0; line < title_.size(); ++line)
        text += text_at(12.0, 21.0 + kHeadingLine * static_cast<double>(line), "start", title_[line]);
    return "<g class=\"heading\">" + text + "</g>\n";
}

std::string Canvas::legend() const {
    std::string text;
    double at = 12.0, base = heading_height() + 12.0;
    for (const LegendEntry& entry : legend_) {
        if (at > 12.0 && at + entry.width() > plot_.width - 8.0) at = 12.0, base += kLegendRow;
        text += "<g transform=\"translate(" + number(at) + " " + number(base) + ")\">" + entry.swatch +
                text_at(24.0, 0.0, "start", entry.name) + "</g>\n";
        at += entry.width();
    }
    return text;
}

std::string Canvas::axes() const {
    std::string text;
    for (const PlotTick& tick : x_.ticks) {
        text += grid_line(x(tick.at), top_, x(tick.at), bottom_);
        text += text_at(x(tick.at), bottom_ + 17.0, "middle", tick.label);
        if (plot_.height > kTall) text += text_at(x(tick.at), top_ - 7.0, "middle", tick.label);
    }
    for (const PlotTick& tick : y_.ticks) {
        text += grid_line(left_, y(tick.at), right_, y(tick.at));
        text += text_at(left_ - 7.0, y(tick.at) + 4.0, "end", tick.label);
    }
    text += text_at(0.5 * (left_ + right_), bottom_ + 38.0, "middle", plot_.x.label);
    if (!plot_.y.label.empty())
        text += "<g transform=\"translate(16 " + number(0.5 * (top_ + bottom_)) + ") rotate(-90)\">" +
                text_at(0.0, 0.0, "middle", plot_.y.label) + "</g>\n";
    return text + "<rect class=\"frame\"" + attribute("x", left_) + attribute("y", top_) +
           attribute("width", right_ - left_) + attribute("height", bottom_ - top_) + "/>\n";
}

std::string Canvas::band() const {
    if (!plot_.band) return "";
    const auto edge = [&](double value, double otherwise) { return y_.shows(value) ? y(value) : otherwise; };
    const double upper = std::clamp(edge(plot_.band->upper, top_), top_, bottom_);
    const double lower = std::clamp(edge(plot_.band->lower, bottom_), top_, bottom_);
    return "<rect class=\"band\"" + attribute("x", left_) + attribute("y", upper) + attribute("width", right_ - left_) +
           attribute("height", std::max(2.0, lower - upper)) + "/>\n";
}

std::string Canvas::bars(const PlotSeries& series) const {
    std::string text;
    for (const PlotBar& bar : series.bars) {
        const double from = std::min(y(bar.base), y(bar.top)), size = std::abs(y(bar.base) - y(bar.top));
        text += "<rect class=\"bar " + std::string(ink_class(series.ink)) + "\"" + attribute("x", x(bar.left)) +
                attribute("y", from) + attribute("width", x(bar.right) - x(bar.left)) + attribute("height", size) +
                "/>\n";
    }
    return text;
}

std::string Canvas::points(const PlotSeries& series) const {
    std::string text;
    for (const DVec2 point : series.points)
        if (shows(point))
            text += "<circle class=\"point " + std::string(ink_class(series.ink)) + "\"" + attribute("cx", x(point.x)) +
                    attribute("cy", y(point.y)) + " r=\"3\"/>\n";
    return text;
}

std::string Canvas::lines(const PlotSeries& series) const {
    std::string path;
    bool drawing = false;
    for (const DVec2 point : series.points) {
        if (shows(point)) path += (drawing ? "L" : "M") + number(x(point.x)) + " " + number(y(point.y));
        drawing = shows(point);
    }
    const std::string dashed = series.mark == Mark::dashed ? " dashed" : "";
    return "<path class=\"line " + std::string(ink_class(series.ink)) + dashed + "\" d=\"" + path + "\"/>\n";
}

// Curves and bars, in an <svg> element of the size of the axes, so that no part is drawn outside them.
std::string Canvas::series() const {
    const std::string box =
        number(left_) + " " + number(top_) + " " + number(right_ - left_) + " " + number(bottom_ - top_);
    std::string text = "<svg" + attribute("x", left_) + attribute("y", top_) + attribute("width", right_ - left_) +
                       attribute("height", bottom_ - top_) + " viewBox=\"" + box + "\">\n" + band();
    for (const PlotSeries& one : plot_.series) {
        text += bars(one);
        if (one.points.empty()) continue;
        text += one.mark == Mark::points ? points(one) : lines(one);
    }
    return text + "</svg>\n";
}

std::string Canvas::draw() const {
    const std::string width = std::to_string(plot_.width), height = std::to_string(plot_.height);
    return "<svg class=\"plot\" role=\"img\" viewBox=\"0 0 " + width + " " + height + "\" width=\"" + width +
           "\" height=\"" + height + "\">\n<title>" + escape_markup(plot_.title) + "</title>\n" + heading() + legend() +
           axes() + series() + "</svg>\n";
}

}  // namespace

std::string to_svg(const Plot& plot) { return Canvas(plot).draw(); }

}  // namespace tumble::tools
