#include "tools/health/health_plots.hpp"

#include <functional>
#include <string>

namespace tumble::tools {

namespace {

using Samples = std::vector<HealthSample>;
using SampleValue = std::function<double(const HealthSample&)>;

PlotSeries sample_line(const Samples& samples, const std::string& name, Ink ink, const SampleValue& value) {
    PlotSeries series{.name = name, .ink = ink, .mark = Mark::line};
    for (const HealthSample& sample : samples) series.points.push_back({sample.time, value(sample)});
    return series;
}

Plot over_time(const std::string& title, const std::string& unit, std::vector<PlotSeries> series) {
    return {.title = title, .x = {.label = "time, s"}, .y = {.label = unit}, .series = std::move(series), .width = 560};
}

}  // namespace

std::vector<Plot> health_plots(const Samples& samples) {
    return {
        over_time("Energy", "J",
                  {sample_line(samples, "kinetic", Ink::tumble, [](const auto& s) { return s.kinetic; }),
                   sample_line(samples, "potential", Ink::second, [](const auto& s) { return s.potential; }),
                   sample_line(samples, "both less work", Ink::violet,
                               [](const auto& s) { return s.kinetic + s.potential - s.work; })}),
        over_time("Momentum", "kg m/s",
                  {sample_line(samples, "to the right", Ink::tumble, [](const auto& s) { return s.momentum.x; }),
                   sample_line(samples, "upwards", Ink::second, [](const auto& s) { return s.momentum.y; })}),
        over_time("Deepest overlap and largest joint error", "m",
                  {sample_line(samples, "overlap", Ink::tumble, [](const auto& s) { return s.overlap; }),
                   sample_line(samples, "joint error", Ink::second, [](const auto& s) { return s.joint_error; })}),
        over_time("Dynamic bodies that are awake", "bodies",
                  {sample_line(samples, "", Ink::tumble, [](const auto& s) { return static_cast<double>(s.awake); })}),
        over_time("Wall clock of a step", "ms",
                  {sample_line(samples, "", Ink::tumble, [](const auto& s) { return s.milliseconds; })}),
    };
}

}  // namespace tumble::tools
