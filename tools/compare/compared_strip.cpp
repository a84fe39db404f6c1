#include "tools/compare/compared_strip.hpp"

#include "tools/compare/compared_plots.hpp"

namespace tumble::tools {

namespace {

constexpr int kPlotHeight = 230;  // px
constexpr int kPlots = 2;

int columns_of(const PairPictures& pictures) { return pictures.is_overlaid ? 1 : kPlots; }

}  // namespace

PlotStrip compared_strip(const ComparedRuns& runs, const PairPictures& pictures, bool is_dark) {
    const int columns = columns_of(pictures), width = pair_size(pictures).width / columns;
    return {{distance_plot(runs, width, kPlotHeight), energy_plot(runs, width, kPlotHeight)},
            columns,
            is_dark,
            pictures.renderer};
}

int compared_strip_height(const PairPictures& pictures) { return kPlotHeight * (kPlots / columns_of(pictures)); }

}  // namespace tumble::tools
