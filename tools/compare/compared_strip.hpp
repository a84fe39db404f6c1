// The plots below a frame of a comparison.
#pragma once

#include "tools/compare/compared_pictures.hpp"
#include "tools/compare/compared_runs.hpp"
#include "tools/output/plot_strip.hpp"

namespace tumble::tools {

// The distance of both runs and their energies: beside each other below two pictures, one below the other if these are
// overlaid. The runs must have a step. Throws RenderError.
PlotStrip compared_strip(const ComparedRuns& runs, const PairPictures& pictures, bool is_dark);

int compared_strip_height(const PairPictures& pictures);  // px

}  // namespace tumble::tools
