// The plots of a table of expressions.
#pragma once

#include <optional>
#include <vector>

#include "tools/output/plot.hpp"
#include "tools/plot/expression_table.hpp"

namespace tumble::tools {

struct PlotChoice {
    bool has_abscissa = false;       // the last column is the horizontal axis, instead of the time
    bool is_together = false;        // all expressions over one vertical axis
    int width = 1280, height = 720;  // px, of all plots
    std::string title{};             // above the first plot; may be empty
};

// One plot for each expression, one below the other, or one for all. Throws CLI::ValidationError if the height is too
// small for them.
std::vector<Plot> plots_of(const ExpressionTable& table, const PlotChoice& choice);

}  // namespace tumble::tools
