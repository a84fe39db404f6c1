#include "tools/output/plot_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace tumble::tools {

namespace {

constexpr double kCharacter = 7.2;  // px, the width of an average character of that size
constexpr double kHeadingCharacter = 8.6;
constexpr double kLegendRow = 20.0;    // px
constexpr int kTall = 700;             // px, above which the horizontal axis has labels at both ends
constexpr double kTickSpacing = 42.0;  // px between ticks of the vertical axis, at least
constexpr double kColumn = 0.5;        // px, in which the points of a line are one

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

PlotScale scale_of(const PlotAxis& axis, Extremes extremes, int most_ticks, bool has_margin) {
    const PlotRange range = axis.range ? *axis.range : padded(extremes, axis.logarithmic, has_margin);
    PlotScale scale;
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

std::vector<LegendEntry> legend_of(const Plot& plot) {
    std::vector<LegendEntry> entries;
    for (const PlotSeries& series : plot.series)
        if (!series.name.empty()) entries.push_back({&series, series.name, {}});
    if (plot.band) entries.push_back({nullptr, plot.band->name, {}});
    return entries;
}

// Sets the entries in rows below the title, and returns the number of rows.
int place(std::vector<LegendEntry>& entries, double width, double base) {
    int rows = entries.empty() ? 0 : 1;
    double at = 12.0;
    for (LegendEntry& entry : entries) {
        if (at > 12.0 && at + entry.width() > width - 8.0) at = 12.0, base += kLegendRow, ++rows;
        entry.at = {at, base};
        at += entry.width();
    }
    return rows;
}

// A run of points in one column of pixels.
struct Column {
    DVec2 first, lowest, highest, last;

    explicit Column(DVec2 point) : first(point), lowest(point), highest(point), last(point) {}

    void add(DVec2 point) {
        last = point;
        if (point.y < lowest.y) lowest = point;
        if (point.y > highest.y) highest = point;
    }
    void append_to(std::vector<DVec2>& line) const {
        for (const DVec2 point : {first, lowest, highest, last})
            if (line.empty() || point.x != line.back().x || point.y != line.back().y) line.push_back(point);
    }
};

std::vector<DVec2> thinned(const std::vector<DVec2>& line) {
    std::vector<DVec2> kept;
    Column column(line.front());
    for (const DVec2 point : line) {
        if (std::floor(point.x / kColumn) == std::floor(column.first.x / kColumn)) {
            column.add(point);
            continue;
        }
        column.append_to(kept);
        column = Column(point);
    }
    column.append_to(kept);
    return kept;
}

}  // namespace

double PlotScale::transformed(double value) const { return logarithmic ? std::log10(value) : value; }
bool PlotScale::shows(double value) const { return std::isfinite(value) && (!logarithmic || value > 0.0); }

double LegendEntry::width() const { return 34.0 + kCharacter * static_cast<double>(name.size()); }

PlotLayout::PlotLayout(const Plot& of, double least_left)
    : plot(of),
      title(lines_of(of.title, static_cast<std::size_t>((of.width - 24.0) / kHeadingCharacter))),
      legend(legend_of(of)),
      has_upper_labels(of.height > kTall),
      right(of.width - 18.0) {
    const double heading = of.title.empty() ? 14.0 : 34.0 + kHeadingLine * static_cast<double>(title.size() - 1);
    const int rows = place(legend, of.width, heading + 12.0);
    top = heading + kLegendRow * rows + (has_upper_labels ? kLegendRow : 0.0);
    bottom = of.height - (of.x.label.empty() ? 28.0 : 48.0);
    y_scale = scale_of(of.y, extremes_of_y(of), std::max(2, static_cast<int>((bottom - top) / kTickSpacing)), true);
    std::size_t longest = 0;
    for (const PlotTick& tick : y_scale.ticks) longest = std::max(longest, tick.label.size());
    left = std::max(least_left, (of.y.label.empty() ? 14.0 : 34.0) + kCharacter * static_cast<double>(longest));
    const bool has_bars = std::ranges::any_of(of.series, [](const PlotSeries& s) { return !s.bars.empty(); });
    x_scale = scale_of(of.x, extremes_of_x(of), std::max(2, static_cast<int>((right - left) / 80.0)), !has_bars);
}

std::vector<std::vector<DVec2>> PlotLayout::lines(const PlotSeries& series) const {
    std::vector<std::vector<DVec2>> lines;
    bool drawing = false;
    for (const DVec2 point : series.points) {
        const bool shown = shows(point);
        if (shown && !drawing) lines.emplace_back();
        if (shown) lines.back().push_back({x(point.x), y(point.y)});
        drawing = shown;
    }
    const bool are_many = static_cast<double>(series.points.size()) > 2.0 * (right - left) / kColumn;
    if (are_many)
        for (std::vector<DVec2>& line : lines) line = thinned(line);
    return lines;
}

double common_left(std::span<const Plot> plots) {
    double left = 0.0;
    for (const Plot& plot : plots) left = std::max(left, PlotLayout(plot).left);
    return left;
}

PlotRange PlotLayout::band() const {
    const auto edge = [&](double value, double otherwise) { return y_scale.shows(value) ? y(value) : otherwise; };
    const double upper = std::clamp(edge(plot.band->upper, top), top, bottom);
    const double lower = std::clamp(edge(plot.band->lower, bottom), top, bottom);
    return {upper, upper + std::max(2.0, lower - upper)};
}

}  // namespace tumble::tools
