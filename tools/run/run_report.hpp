// The results of a run: summary.json, and a short text for the terminal.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/health/health_report.hpp"
#include "tools/run/frame_views.hpp"
#include "tumble/counters.hpp"
#include "tumble/scene.hpp"

namespace tumble::tools {

// Files that a run wrote, all of one kind.
struct WrittenFiles {
    std::string kind;            // "frames", "events", "trajectory", "contacts", "hashes", "replay", "report", "video",
                                 // "raw video", "masks", "labels", "boxes"
    std::filesystem::path path;  // of the first
    std::uint64_t count = 0;
    std::uint64_t bytes = 0;  // of all
};

struct RunReport {
    std::string scene_name;
    std::uint64_t scene_hash = 0;
    std::vector<SceneDraw> draws;  // the numbers of the scene that were drawn at random
    std::uint64_t seed = 0;
    double dt = 0.0;                // s per step
    std::uint64_t steps = 0;        // done
    std::uint64_t timed_steps = 0;  // of them, by this process: those of `stages`
    double simulate_seconds = 0.0;  // wall clock
    double render_seconds = 0.0;    // drawing, and waiting for the encoder threads
    double encode_seconds = 0.0;    // summed over the encoder's threads
    double total_seconds = 0.0;
    std::size_t bodies = 0;
    StepCounters counters;  // of the last step
    int islands = 0;        // at the end, awake and asleep
    StageTimes stages;      // summed over the steps, ms
    WorldMemory memory;     // at the end
    std::uint64_t state_hash = 0;
    std::vector<WrittenFiles> files;
    FrameSize frame_size;
    std::vector<FrameView> views;          // empty if no frame was drawn
    std::optional<HealthReport> health{};  // of a run with a report
    bool complete = false;
};

// Adds the times of a step to a sum.
void add_times(StageTimes& sum, const StageTimes& step);

std::string to_json(const RunReport& report);

// A few lines for a terminal.
std::string to_text(const RunReport& report);

}  // namespace tumble::tools
