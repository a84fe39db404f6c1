#include "tools/output/plot_strip.hpp"

#include <cmath>
#include <span>
#include <utility>

#include "tools/output/image_grid.hpp"
#include "tools/output/plot_colors.hpp"
#include "tools/output/plot_layout.hpp"

namespace tumble::tools {

PlotStrip::PlotStrip(std::vector<Plot> plots, int columns, bool is_dark, RenderBackend backend)
    : plots_(std::move(plots)),
      left_(common_left(plots_)),
      columns_(columns),
      page_color_(color_of(kPageColor, is_dark)),
      time_color_(color_of(plot_color(Ink::limit), is_dark)) {
    for (const Plot& plot : plots_)
        images_.push_back(
            draw_image(to_drawing(std::span(&plot, 1), {.least_left = left_, .is_dark = is_dark}), backend));
}

Image PlotStrip::at(double time) const {
    std::vector<Image> images = images_;
    for (std::size_t i = 0; i < images.size(); ++i) {
        const PlotLayout layout(plots_[i], left_);
        const int x = static_cast<int>(std::lround(layout.x(time)));
        for (const int column : {x, x + 1})
            paint_column(images[i], column, static_cast<int>(layout.top), static_cast<int>(layout.bottom), time_color_);
    }
    return image_grid(images, columns_, 0, page_color_);
}

}  // namespace tumble::tools
