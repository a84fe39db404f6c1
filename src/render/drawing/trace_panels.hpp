// The panels of the drawing of a GJK trace: the Minkowski difference, each iteration, and the last simplex of an
// overlap.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/drawing/pair_drawing.hpp"

namespace tumble::render {

// The support vertices of a trace, numbered from 1 in the order in which GJK found them.
class FoundVertices {
public:
    explicit FoundVertices(const DistanceTrace& trace);

    // Two index pairs have two numbers even if their vertices coincide.
    std::string number(VertexPair pair) const;
    const std::vector<DVec2>& positions() const { return positions_; }

private:
    void add(VertexPair pair, DVec2 position);

    std::vector<VertexPair> pairs_;
    std::vector<DVec2> positions_;
};

// The data that all panels of one trace share.
struct TraceFigure {
    const PairDrawing& pair;
    const DistanceTrace& trace;
    FoundVertices found;
    std::vector<DVec2> core;  // the outline of the cores' difference
    std::vector<DVec2> view;  // points that the panel of each iteration must contain
    bool is_zoomed = false;   // the view is smaller than the difference
};

// The panels of the iterations show the found vertices and the origin if those fill less than half of the difference,
// else all of it.
TraceFigure make_trace_figure(const PairDrawing& pair, const DistanceTrace& trace);

// The Minkowski difference with the found vertices and the point nearest to the origin.
void draw_difference_panel(Drawing& drawing, PixelRect rect, const TraceFigure& figure);

// Iteration k: the simplex, its nearest point, the search direction and the support vertex.
void draw_step_panel(Drawing& drawing, PixelRect rect, const TraceFigure& figure, std::size_t k);

// The simplex that contains the origin, of overlapping cores.
void draw_enclosing_panel(Drawing& drawing, PixelRect rect, const TraceFigure& figure);

}  // namespace tumble::render
