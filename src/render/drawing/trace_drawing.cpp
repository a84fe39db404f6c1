// The drawing of a GJK trace: the pair and its Minkowski difference side by side, then the iterations in rows, then the
// bounds.
#include <algorithm>

#include "render/drawing/bounds_plot.hpp"
#include "render/drawing/pair_drawing.hpp"
#include "render/drawing/trace_panels.hpp"

namespace tumble {

using namespace render;

namespace {

constexpr int kWidth = 1280;
constexpr double kGap = 16.0;
constexpr double kTopHeight = 430.0;   // of the two large panels
constexpr double kStepHeight = 270.0;  // of the panel of one iteration
constexpr int kMostColumns = 4;

std::string summary(const DistanceResult& result) {
    if (result.status == DistanceStatus::invalid) return "invalid input";
    const std::string count =
        std::to_string(result.iterations) + (result.iterations == 1 ? " support vertex" : " support vertices");
    return std::string(to_string(result.status)) + ": signed distance " + short_number(result.distance) +
           " m, normal (" + short_number(result.normal.x) + ", " + short_number(result.normal.y) + "), " + count +
           " computed";
}

}  // namespace

Drawing draw_trace(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                   const DistanceTrace& trace) {
    const PairDrawing pair(a, world_from_a, b, world_from_b);
    const TraceFigure figure = make_trace_figure(pair, trace);
    const int steps = static_cast<int>(trace.steps.size());
    const bool encloses = trace.result.certificate.cores_overlap && !trace.result.reached_cap && steps > 0;
    const int panels = steps + (encloses ? 1 : 0) + (steps > 1 ? 1 : 0);
    const int rows = (panels + kMostColumns - 1) / kMostColumns;
    const int columns = rows > 0 ? std::max((panels + rows - 1) / rows, 2) : 1;
    const double steps_top = 48.0 + kTopHeight + kGap + 48.0;
    Drawing drawing;
    drawing.width = kWidth;
    drawing.height = static_cast<int>(steps_top + rows * (kStepHeight + kGap));

    drawing.text({kGap, 32.0}, summary(trace.result), 18.0, ink::kText);
    const double half = 0.5 * (kWidth - 3.0 * kGap);
    draw_pair_panel(drawing, {kGap, 48.0, half, kTopHeight}, pair, trace.result);
    draw_difference_panel(drawing, {2.0 * kGap + half, 48.0, half, kTopHeight}, figure);
    if (steps == 0) return drawing;

    drawing.text({kGap, steps_top - 30.0},
                 "Each iteration: the simplex (green), its point v nearest to the origin (red), the search direction "
                 "(arrow), and the support vertex, farthest along it (ring).",
                 13.0, ink::kText);
    drawing.text({kGap, steps_top - 12.0},
                 std::string("No point of A - B lies beyond the thin line through the support vertex, which proves the "
                             "lower bound.") +
                     (figure.is_zoomed ? " The panels show only the part of A - B near the origin." : ""),
                 13.0, ink::kText);
    const double width = (kWidth - (columns + 1) * kGap) / columns;
    for (int k = 0; k < panels; ++k) {
        const PixelRect rect{kGap + k % columns * (width + kGap), steps_top + k / columns * (kStepHeight + kGap), width,
                             kStepHeight};
        if (k < steps)
            draw_step_panel(drawing, rect, figure, static_cast<std::size_t>(k));
        else if (encloses && k == steps)
            draw_enclosing_panel(drawing, rect, figure);
        else
            draw_bounds_panel(drawing, rect, trace.steps);
    }
    return drawing;
}

}  // namespace tumble
