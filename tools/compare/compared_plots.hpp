// The numbers of two runs over time. Sizes are in pixels.
#pragma once

#include "tools/compare/compared_runs.hpp"
#include "tools/output/plot.hpp"

namespace tumble::tools {

// The largest difference of a body in x or y, as `diff` has it, and a dashed line where they first differ.
Plot distance_plot(const ComparedRuns& runs, int width, int height);

// The same and the largest difference of a velocity, logarithmic.
Plot growth_plot(const ComparedRuns& runs, int width, int height);

// The kinetic and potential energies of both runs.
Plot energy_plot(const ComparedRuns& runs, int width, int height);

}  // namespace tumble::tools
