// The plots of a parity report.
#pragma once

#include <span>

#include "reference/parity/parity.hpp"
#include "tumble/drawing.hpp"

namespace tumble::tools {

// Draws a histogram of |error| / S for each family over one logarithmic axis: tumble's counts upwards, Box2D's
// downwards, each relative to its largest bin in the family.
Drawing draw_error_histograms(std::span<const reference::ParityRow> families);

}  // namespace tumble::tools
