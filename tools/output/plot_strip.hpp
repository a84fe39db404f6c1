// Plots over the time below a frame, with the time of the frame.
#pragma once

#include <vector>

#include "tools/output/plot.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

class PlotStrip {
public:
    // Plots of one size, `columns` of them in a row. They are drawn once. Throws RenderError.
    PlotStrip(std::vector<Plot> plots, int columns, bool is_dark, RenderBackend backend);

    // With a line at that time (s) in each plot.
    Image at(double time) const;

private:
    std::vector<Plot> plots_;
    std::vector<Image> images_;
    double left_;
    int columns_;
    Color page_color_, time_color_;
};

}  // namespace tumble::tools
