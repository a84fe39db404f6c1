// Simulates a scene, draws its frames and writes its files, for `run` and `demo`.
#pragma once

#include "tools/run/run_options.hpp"
#include "tools/run/run_report.hpp"
#include "tumble/scene.hpp"

namespace tumble::tools {

// Writes the results to options.folder. Ends early on SIGINT, SIGHUP or SIGTERM; `complete` is false in the report
// then. Throws SimulationDiverged, FileError or RenderError. An error after the first step has been recorded leaves a
// summary.json with "complete": false.
RunReport simulate(const Scene& scene, const RunOptions& options);

}  // namespace tumble::tools
