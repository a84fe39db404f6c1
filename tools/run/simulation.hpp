// The main job, shared by `run` and `demo`: simulate a scene, draw its frames, write the files that were asked for.
#pragma once

#include "tools/run/run_options.hpp"
#include "tools/run/run_report.hpp"
#include "tumble/scene.hpp"

namespace tumble::tools {

// Runs the scene into options.folder. Ends early on SIGINT or SIGTERM, with a report that is not complete. Throws what
// went wrong (SimulationDiverged, FileError, RenderError) after leaving a summary.json that is not complete.
RunReport simulate(const Scene& scene, const RunOptions& options);

}  // namespace tumble::tools
