// A column of a sweep's table over one or two others, as a drawing.
#pragma once

#include <filesystem>
#include <string>

#include "tumble/drawing.hpp"

namespace tumble::tools {

struct SweepPlot {
    std::string x, y, value;  // columns; without y the value is the vertical axis
};

// With y a heat map: each pair of values of x and y is a cell, coloured by the mean value of its runs. Drawn
// parameters, which have a value for each run, are gathered in 40 by 40 cells. Without y a dot for each run. Lines
// without a number in one of the columns are left out. Throws FileError, and InputError for a table without these
// columns or numbers.
Drawing draw_sweep(const std::filesystem::path& table, const SweepPlot& plot);

}  // namespace tumble::tools
