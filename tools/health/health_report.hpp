// What the report of a run's health contains, and its JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/output/json_writer.hpp"
#include "tumble/render.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

struct ReportedFinding {
    HealthFinding finding;
    std::vector<std::string> bodies;  // the names of HealthFinding::bodies
    std::optional<Image> picture{};   // of its moment; none if the run was interrupted or nothing draws
};

struct HealthReport {
    std::string scene_name;
    std::uint64_t steps = 0;
    double time = 0.0;  // s, simulated
    std::size_t bodies = 0;
    std::vector<ReportedFinding> findings;
    std::vector<HealthExtreme> extremes;
    std::vector<HealthSample> samples;
    std::vector<SlowStep> slow_steps;
    std::string note{};           // why the run ended early; may be empty
    std::string picture_error{};  // why there are no pictures; may be empty
};

// `built` is the state that was observed last.
HealthReport make_health_report(const Scene& scene, const SceneWorld& built, const HealthWatch& watch);

// An object of `findings`, `extremes` and `slow_steps`.
void write_health(JsonWriter& json, const HealthReport& report);

}  // namespace tumble::tools
