// Watches the health of a run, and writes its report.
#pragma once

#include <cstdint>
#include <string>

#include "tools/health/health_report.hpp"
#include "tools/run/run_options.hpp"
#include "tumble/file.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

class HealthOutput {
public:
    // The scene must outlive the object. Throws FileError.
    HealthOutput(const Scene& scene, const RunOptions& options);

    // To be called for the initial state and after each step.
    void record(const SceneWorld& built) { watch_.observe(built); }

    // Writes the page and returns its size in bytes. A run that ended early has a `note` that says so; its page has no
    // pictures, which need a second run.
    std::uint64_t finish(const SceneWorld& built, const std::string& note);

    // Set by finish().
    const HealthReport& report() const noexcept { return report_; }

private:
    const Scene& scene_;
    RenderBackend renderer_;
    OutputFile file_;
    HealthWatch watch_;
    HealthReport report_;
};

}  // namespace tumble::tools
