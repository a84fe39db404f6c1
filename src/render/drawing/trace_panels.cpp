#include "render/drawing/trace_panels.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"

namespace tumble::render {

void FoundVertices::add(VertexPair pair, DVec2 position) {
    if (std::ranges::find(pairs_, pair) != pairs_.end()) return;
    pairs_.push_back(pair);
    positions_.push_back(position);
}

FoundVertices::FoundVertices(const DistanceTrace& trace) {
    if (trace.steps.empty()) return;
    const TraceStep& first = trace.steps.front();
    for (std::size_t i = 0; i < first.count; ++i) add(first.simplex[i], first.vertices[i]);
    for (const TraceStep& step : trace.steps) add(step.support, step.support_vertex);
}

std::string FoundVertices::number(VertexPair pair) const {
    const auto at = std::ranges::find(pairs_, pair);
    TUMBLE_CHECK(at != pairs_.end());
    return std::to_string(at - pairs_.begin() + 1);
}

namespace {

constexpr double kCaptionSize = 12.0;

double larger_side(const std::vector<DVec2>& points) {
    DVec2 lower = points.front(), upper = points.front();
    for (const DVec2 p : points) {
        lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
        upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
    }
    return std::max(upper.x - lower.x, upper.y - lower.y);
}

void draw_origin(Panel& panel, Drawing& drawing) {
    const DVec2 o = panel.to_pixels(DVec2{});
    drawing.line(o - DVec2{7.0, 0.0}, o + DVec2{7.0, 0.0}, 2.0, ink::kText);
    drawing.line(o - DVec2{0.0, 7.0}, o + DVec2{0.0, 7.0}, 2.0, ink::kText);
}

// Draws a text beside a point of the plane, on the side that `direction` (of any length) points to.
void draw_label_beside(Panel& panel, DVec2 at, DVec2 direction, const std::string& text, Color color) {
    constexpr double kAway = 16.0;
    const double reach = kAway + 3.0 * static_cast<double>(text.size() - 1), norm = std::max(length(direction), 1e-300);
    panel.label(at, {reach * direction.x / norm, 5.0 - kAway * direction.y / norm}, text, 13.0, color);
}

// Draws a found vertex with its number outside of the difference, or inside if the line to the origin is there.
void draw_vertex(Panel& panel, const TraceFigure& figure, DVec2 w, const std::string& number) {
    constexpr double kInLine = 0.8;  // cosine
    panel.dot(w, 4.0, ink::kSimplex);
    DVec2 outwards = w - mean(figure.core);
    const DVec2 to_origin = -w;
    if (dot(outwards, to_origin) > kInLine * length(outwards) * length(to_origin)) outwards = -outwards;
    draw_label_beside(panel, w, outwards, number, ink::kSimplex);
}

// Draws each vertex once. A vertex too near to another one gets no number here; the panels of the iterations show it.
void draw_found_vertices(Panel& panel, const TraceFigure& figure) {
    constexpr double kLegible = 16.0;  // px
    const std::vector<DVec2>& positions = figure.found.positions();
    for (std::size_t k = 0; k < positions.size(); ++k) {
        const DVec2 at = panel.to_pixels(positions[k]);
        const bool is_free = std::none_of(positions.begin(), positions.begin() + static_cast<std::ptrdiff_t>(k),
                                          [&](DVec2 other) { return length(panel.to_pixels(other) - at) < kLegible; });
        if (is_free)
            draw_vertex(panel, figure, positions[k], std::to_string(k + 1));
        else
            panel.dot(positions[k], 4.0, ink::kSimplex);
    }
}

// True if the support vertex lies farther along the direction than the simplex by no more than rounding, which the
// bounds of the result contain.
bool is_no_farther(const TraceStep& step, const DistanceResult& result) {
    const double progress = dot(step.direction, step.support_vertex - step.vertices[0]);
    return progress <= (result.upper - result.lower) * length(step.direction);
}

// Why the loop ended with its last step: what the step shows, and whether an exhaustive search followed. An overlap has
// a panel of its own.
std::string end_caption(const DistanceTrace& trace) {
    const TraceStep& last = trace.steps.back();
    const DistanceResult& result = trace.result;
    if (result.certificate.cores_overlap && !result.reached_cap) return "";
    // The first support vertex is no step; those of an exhaustive search are none either.
    const std::string then = result.iterations > trace.steps.size() + 1 ? ": all pairs searched" : ": done";
    const auto simplex_end = last.simplex.begin() + last.count;
    if (result.reached_cap) return ", limit reached" + then;
    if (std::find(last.simplex.begin(), simplex_end, last.support) != simplex_end) return " again" + then;
    if (is_no_farther(last, result)) return ", no farther" + then;
    const bool is_raised = trace.steps.size() < 2 || last.lower > trace.steps[trace.steps.size() - 2].lower;
    // A support that is farther, and raises the bound, ends the loop only if the origin then lies in the simplex: the
    // cores touch, or overlap by no more than rounding.
    return (is_raised ? ", origin inside" : ", no better bound") + then;
}

// The result of an iteration in one line.
std::string step_caption(const TraceFigure& figure, std::size_t k) {
    TUMBLE_CHECK(k < figure.trace.steps.size());
    const TraceStep& step = figure.trace.steps[k];
    const std::string support = figure.found.number(step.support);
    const std::string v = step.count == 1 ? "v: vertex " + figure.found.number(step.simplex[0])
                                          : "v: between " + figure.found.number(step.simplex[0]) + " and " +
                                                figure.found.number(step.simplex[1]);
    return v + "; support: " + support + (k + 1 == figure.trace.steps.size() ? end_caption(figure.trace) : "");
}

}  // namespace

TraceFigure make_trace_figure(const PairDrawing& pair, const DistanceTrace& trace) {
    constexpr double kSmallPart = 0.5;
    TraceFigure figure{pair, trace, FoundVertices(trace), pair.outline_difference(0.0), {}, false};
    figure.view = figure.core;
    figure.view.push_back({});
    std::vector<DVec2> near = figure.found.positions();
    near.push_back({});
    const double size = larger_side(near);
    if (size > 0.0 && size < kSmallPart * larger_side(figure.view)) {
        figure.view = near;
        figure.is_zoomed = true;
    }
    return figure;
}

void draw_difference_panel(Drawing& drawing, PixelRect rect, const TraceFigure& figure) {
    const DistanceResult& result = figure.trace.result;
    const double radius = figure.pair.radii();
    const std::vector<DVec2> grown = figure.pair.outline_difference(radius);
    std::vector<DVec2> view = grown;
    view.push_back({});
    const std::string caption =
        radius > 0.0 ? "GJK uses the cores; the thin outline adds both radii, " + short_number(radius) + " m" : "";
    Panel panel(drawing,
                draw_frame(drawing, rect, "Minkowski difference A - B: as far from the origin as A is from B", caption),
                view);
    if (radius > 0.0) panel.fill(grown, kTransparent, 1.0, ink::kFaint);
    panel.fill(figure.core, ink::kDifferenceFill, 2.0, ink::kDifference);
    draw_origin(panel, drawing);
    if (result.status == DistanceStatus::invalid) return;
    const DVec2 nearest = -(result.distance + radius) * result.normal;
    panel.line({}, nearest, 2.0, ink::kAnswer);
    draw_found_vertices(panel, figure);
    panel.dot(nearest, 4.5, ink::kAnswer);
    panel.label({}, {nearest.x > 0.0 ? -28.0 : 28.0, nearest.y > 0.0 ? 20.0 : -12.0}, "origin", kCaptionSize,
                ink::kText);
}

void draw_step_panel(Drawing& drawing, PixelRect rect, const TraceFigure& figure, std::size_t k) {
    const TraceStep& step = figure.trace.steps[k];
    const std::string title = std::to_string(k + 1) + ":  between " + short_number(std::max(0.0, step.lower)) +
                              " and |v| = " + short_number(step.upper);
    Panel panel(drawing, draw_frame(drawing, rect, title, step_caption(figure, k)), figure.view);
    panel.fill(figure.core, ink::kDifferenceFill, 1.0, ink::kDifference);
    const DVec2 along =
        (2.0 * larger_side(figure.view) / std::max(length(step.direction), 1e-300)) * perp(step.direction);
    panel.line(step.support_vertex - along, step.support_vertex + along, 1.0, ink::kText);
    const std::vector<DVec2> simplex(step.vertices.begin(), step.vertices.begin() + step.count);
    panel.fill(simplex, ink::kSimplexFill, 3.0, ink::kSimplex);
    panel.dashed(step.closest, {}, 1.5, ink::kAnswer);
    panel.arrow(step.closest, step.direction, 32.0, ink::kAnswer);
    for (std::size_t i = 0; i < step.count; ++i)
        draw_vertex(panel, figure, step.vertices[i], figure.found.number(step.simplex[i]));
    panel.dot(step.closest, 4.0, ink::kAnswer);
    draw_vertex(panel, figure, step.support_vertex, figure.found.number(step.support));
    panel.ring(step.support_vertex, 7.0, ink::kText);
    draw_origin(panel, drawing);
}

void draw_enclosing_panel(Drawing& drawing, PixelRect rect, const TraceFigure& figure) {
    const TraceStep& last = figure.trace.steps.back();
    const PixelRect inner =
        draw_frame(drawing, rect, "The simplex contains the origin: overlap", "depth: to the nearest face of A - B");
    Panel panel(drawing, inner, figure.view);
    panel.fill(figure.core, ink::kDifferenceFill, 1.0, ink::kDifference);
    std::vector<DVec2> simplex(last.vertices.begin(), last.vertices.begin() + last.count);
    simplex.push_back(last.support_vertex);
    panel.fill(simplex, ink::kSimplexFill, 3.0, ink::kSimplex);
    for (std::size_t i = 0; i < last.count; ++i)
        draw_vertex(panel, figure, last.vertices[i], figure.found.number(last.simplex[i]));
    draw_vertex(panel, figure, last.support_vertex, figure.found.number(last.support));
    draw_origin(panel, drawing);
}

}  // namespace tumble::render
