// The plots of a health report: energies, momentum, errors, activity and time of the steps over simulated time.
#pragma once

#include <vector>

#include "tools/output/plot.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

std::vector<Plot> health_plots(const std::vector<HealthSample>& samples);

}  // namespace tumble::tools
