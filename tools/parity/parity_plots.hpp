// The plots of a parity report.
#pragma once

#include <span>

#include "reference/parity/parity.hpp"
#include "tools/output/plot.hpp"

namespace tumble::tools {

// A histogram of |error| / S for each family over one logarithmic axis: tumble's counts upwards, Box2D's downwards,
// each relative to its largest bin in the family.
Plot plot_error_histograms(std::span<const reference::ParityRow> families);

}  // namespace tumble::tools
