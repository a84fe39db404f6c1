// Pictures of the moments of findings. They are drawn in a second run of the scene, as runs repeat bit for bit: the
// first run does not know yet which of its moments will be the worst.
#pragma once

#include "tools/health/health_report.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

// Simulates the scene up to its last finding and draws each: a close view of its bodies, which are marked. Sets
// HealthReport::picture_error if nothing draws, a picture of a body is damaged, or `is_stopped`, which is asked before
// each step, answers true; the pictures up to then remain. Throws SimulationDiverged.
void draw_findings(const Scene& scene, RenderBackend renderer, bool (*is_stopped)(), HealthReport& report);

}  // namespace tumble::tools
