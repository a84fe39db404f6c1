// The plots of a parity report.
#pragma once

#include <span>

#include "reference/parity/parity.hpp"
#include "tumble/drawing.hpp"

namespace tumble::tools {

// A strip for each family over one logarithmic axis of |error| / S: tumble's counts upwards, Box2D's downwards, both
// relative to the family's largest bin.
Drawing draw_error_histograms(std::span<const reference::ParityRow> families);

}  // namespace tumble::tools
