#include "tools/compare/compared_plots.hpp"

#include <string>

namespace tumble::tools {

namespace {

PlotSeries line_of(const std::string& name, Ink ink, const ComparedRuns& runs, double (*value)(const ComparedStep&)) {
    PlotSeries line{.name = name, .ink = ink, .mark = Mark::line};
    for (const ComparedStep& step : runs.steps) line.points.push_back({step.time, value(step)});
    return line;
}

double distance_of(const ComparedStep& step) { return step.largest[kPosition].value; }

}  // namespace

Plot distance_plot(const ComparedRuns& runs, int width, int height) {
    Plot plot{.title = "Largest difference of a body in x or y, m",
              .x = {.label = "time, s"},
              .y = {},
              .series = {line_of("", Ink::violet, runs, distance_of)},
              .width = width,
              .height = height};
    if (const auto& first = runs.comparison.first) {
        const double largest = runs.comparison.largest[kPosition].value;
        plot.series.push_back({.name = "first difference",
                               .ink = Ink::limit,
                               .mark = Mark::dashed,
                               .points = {{first->time, 0.0}, {first->time, largest}}});
    }
    return plot;
}

Plot growth_plot(const ComparedRuns& runs, int width, int height) {
    Plot plot{.title = "The same, logarithmic, with the velocities",
              .x = {.label = "time, s"},
              .y = {.label = "m and m/s", .logarithmic = true},
              .series = {},
              .width = width,
              .height = height};
    plot.series.push_back(line_of("position", Ink::violet, runs, distance_of));
    plot.series.push_back(
        line_of("velocity", Ink::teal, runs, [](const ComparedStep& step) { return step.largest[kVelocity].value; }));
    return plot;
}

Plot energy_plot(const ComparedRuns& runs, int width, int height) {
    Plot plot{.title = "Kinetic and potential energy, J",
              .x = {.label = "time, s"},
              .y = {},
              .series = {},
              .width = width,
              .height = height};
    plot.series.push_back(
        line_of(runs.name_a, Ink::tumble, runs, [](const ComparedStep& step) { return step.energy_a; }));
    plot.series.push_back(
        line_of(runs.name_b, Ink::box2d, runs, [](const ComparedStep& step) { return step.energy_b; }));
    plot.series.back().mark = Mark::dashed;
    return plot;
}

}  // namespace tumble::tools
