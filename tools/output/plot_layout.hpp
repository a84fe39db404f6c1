// Where the parts of a plot are, in pixels from the upper left corner of the picture, y down: for all its forms, SVG
// and drawing alike.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/output/plot.hpp"

namespace tumble::tools {

// An axis with its range and ticks decided: maps values to a part of its length, 0 to 1.
struct PlotScale {
    bool logarithmic = false;
    double lower = 0.0, upper = 1.0;  // logarithms to base 10 on a logarithmic axis
    std::vector<PlotTick> ticks;

    double transformed(double value) const;
    bool shows(double value) const;
    double part(double value) const { return (transformed(value) - lower) / (upper - lower); }
};

// One entry of the legend: the series, or none for the band. `at` is the left end of its base line.
struct LegendEntry {
    const PlotSeries* series = nullptr;
    std::string name;
    DVec2 at;

    double width() const;
};

struct PlotLayout {
    // The plot must outlive the layout. The area between the axes begins at least `least_left` px from the left.
    explicit PlotLayout(const Plot& plot, double least_left = 0.0);

    double x(double value) const { return left + (right - left) * x_scale.part(value); }
    double y(double value) const { return bottom - (bottom - top) * y_scale.part(value); }
    bool shows(DVec2 point) const { return x_scale.shows(point.x) && y_scale.shows(point.y); }

    // The lines of a series: one for each run of points that can be shown. Of the points in one half column of
    // pixels only the first, the lowest, the highest and the last are kept if there are many.
    std::vector<std::vector<DVec2>> lines(const PlotSeries& series) const;

    // The upper and lower side of the band.
    PlotRange band() const;

    const Plot& plot;
    std::vector<std::string> title;  // its lines
    std::vector<LegendEntry> legend;
    bool has_upper_labels = false;                            // of the horizontal axis
    double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;  // of the area between the axes
    PlotScale x_scale, y_scale;
};

// Where the areas of plots one below the other begin, so that equal times are one below the other.
double common_left(std::span<const Plot> plots);

inline constexpr double kHeadingLine = 17.0;       // px
inline constexpr double kFirstHeadingBase = 21.0;  // px

}  // namespace tumble::tools
