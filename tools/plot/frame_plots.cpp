#include "tools/plot/frame_plots.hpp"

#include <CLI/CLI.hpp>

#include "tools/plot/expression_plots.hpp"

namespace tumble::tools {

namespace {

constexpr int kExpressionHeight = 180;  // px, of one plot
constexpr int kNarrowestPlot = 320;     // px, of a plot with its axes

}  // namespace

void require_plots(const Scene& scene, const FramePlots& plots) {
    if (plots.expressions.empty()) return;
    if (plots.width < kNarrowestPlot)
        throw CLI::ValidationError(
            "--plot", "needs frames of at least " + std::to_string(kNarrowestPlot) + " pixels in width: give a --size");
    if (plots.height + height_of_plots(plots.expressions.size()) > kLargestFrame)
        throw CLI::ValidationError("--plot", "frames with so many plots are too high; plot fewer expressions");
    compile_expressions(scene, plots.expressions);
    require_few_values(scene, plots.expressions.size(), plots.duration);
}

PlotStrip run_plots(const Scene& scene, const FramePlots& plots) {
    const ExpressionTable table = run_expressions(scene, plots.expressions, {.duration = plots.duration});
    const PlotChoice choice{.width = plots.width, .height = height_of_plots(plots.expressions.size())};
    return {plots_of(table, choice), 1, plots.is_dark, plots.renderer};
}

int height_of_plots(std::size_t expressions) { return kExpressionHeight * static_cast<int>(expressions); }

}  // namespace tumble::tools
