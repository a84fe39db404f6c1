#include "tools/compare/compared_strip.hpp"

#include <cmath>
#include <span>

#include "tools/compare/compared_plots.hpp"
#include "tools/output/image_grid.hpp"
#include "tools/output/plot_layout.hpp"

namespace tumble::tools {

namespace {

constexpr int kPlotHeight = 230;  // px
constexpr int kPlots = 2;
constexpr Color kTimeColor{198, 40, 40, 255};

}  // namespace

int ComparedStrip::height(int columns) { return kPlotHeight * (kPlots / columns); }

// The plots are drawn once; a frame adds the line of its time.
ComparedStrip::ComparedStrip(const ComparedRuns& runs, int width, int columns)
    : plots_{distance_plot(runs, width / columns, kPlotHeight), energy_plot(runs, width / columns, kPlotHeight)},
      left_(common_left(plots_)),
      columns_(columns) {
    for (const Plot& plot : plots_) images_.push_back(draw_image(to_drawing(std::span(&plot, 1), left_)));
}

Image ComparedStrip::at(double time) const {
    std::vector<Image> images = images_;
    for (std::size_t i = 0; i < images.size(); ++i) {
        const PlotLayout layout(plots_[i], left_);
        const int x = static_cast<int>(std::lround(layout.x(time)));
        for (const int column : {x, x + 1})
            paint_column(images[i], column, static_cast<int>(layout.top), static_cast<int>(layout.bottom), kTimeColor);
    }
    return image_grid(images, columns_, 0);
}

}  // namespace tumble::tools
