#include "tools/plot/expression_plots.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <string>

#include "tools/cli/command.hpp"

namespace tumble::tools {

namespace {

constexpr int kSmallestPlot = 120;  // px: less has no room between title and axis

constexpr std::array<Ink, 7> kInkOrder{Ink::tumble, Ink::box2d, Ink::second, Ink::violet,
                                       Ink::limit,  Ink::exact, Ink::teal};

Ink ink_of(std::size_t column) { return kInkOrder[column % kInkOrder.size()]; }
Mark mark_of(std::size_t column) { return column / kInkOrder.size() % 2 == 0 ? Mark::line : Mark::dashed; }

std::vector<DVec2> points_of(const std::vector<double>& x, const std::vector<double>& y) {
    std::vector<DVec2> points;
    points.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) points.push_back({x[i], y[i]});
    return points;
}

int height_of_one(const PlotChoice& choice, std::size_t plots) {
    const int height = choice.height / static_cast<int>(plots);
    if (height >= kSmallestPlot) return height;
    throw CLI::ValidationError("--size", "a plot needs a height of " + std::to_string(kSmallestPlot) + " pixels, and " +
                                             std::to_string(plots) + " plots have " + std::to_string(height) +
                                             " each; use --together, or a greater height");
}

}  // namespace

std::vector<Plot> plots_of(const ExpressionTable& table, const PlotChoice& choice) {
    const std::size_t shown = table.columns.size() - (choice.has_abscissa ? 1 : 0);
    const std::vector<double>& x = choice.has_abscissa ? table.columns.back().values : table.times;
    const std::string label = choice.has_abscissa ? table.columns.back().text : "time, s";
    std::vector<Plot> plots(choice.is_together ? 1 : shown);
    const int height = height_of_one(choice, plots.size());
    for (std::size_t i = 0; i < shown; ++i) {
        Plot& plot = plots[choice.is_together ? 0 : i];
        const ExpressionColumn& column = table.columns[i];
        plot.series.push_back(
            {.name = column.text, .ink = ink_of(i), .mark = mark_of(i), .points = points_of(x, column.values)});
        plot.x.label = label;
        if (!choice.has_abscissa && table.times.back() > table.times.front())
            plot.x.range = PlotRange{table.times.front(), table.times.back()};
        plot.width = choice.width;
        plot.height = height;
    }
    plots.front().title = choice.title;
    return plots;
}

}  // namespace tumble::tools
