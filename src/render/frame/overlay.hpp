// The state of the solver, drawn over the shapes: contact points, normals, bounding boxes, islands, velocities, joints.
#pragma once

#include <string>
#include <vector>

#include "render/canvas/primitives.hpp"
#include "render/style/theme.hpp"
#include "render/view/view.hpp"
#include "tumble/render.hpp"

namespace tumble::render {

void add_overlay(DrawList& list, const View& view, const World& world, const Overlay& overlay, const Colors& colors);

// A line of the legend: the meaning of a mark of this colour.
struct LegendLine {
    enum class Mark { dot, line, area };
    Mark mark;
    Color color;
    std::string text;
};

// A line for each part of the overlay, and one for sensors if the world has any. Empty for an empty overlay.
std::vector<LegendLine> legend_of(const Overlay& overlay, const View& view, const World& world, const Colors& colors);

}  // namespace tumble::render
