// Plots of expressions below the frames of a run.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "tools/output/plot_strip.hpp"
#include "tumble/scene.hpp"

namespace tumble::tools {

struct FramePlots {
    std::span<const std::string> expressions;
    int width = 0, height = 0;         // px, of a frame without plots
    std::optional<double> duration{};  // s; without it the scene's
    bool is_dark = false;
    RenderBackend renderer = RenderBackend::automatic;
};

// Throws CLI::ValidationError for an expression that is wrong, a frame that is too narrow for plots or too high with
// them, or too many values. Does nothing without expressions.
void require_plots(const Scene& scene, const FramePlots& plots);

// Simulates the scene for the values of the expressions, because the axes of the first frame depend on all of them. One
// plot for each, one below the other. Throws RenderError.
PlotStrip run_plots(const Scene& scene, const FramePlots& plots);

// Of all plots, px.
int height_of_plots(std::size_t expressions);

}  // namespace tumble::tools
