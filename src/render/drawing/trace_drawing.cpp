// Draws how GJK found a distance: the pair, the Minkowski difference with the support vertices in the order in which
// they were found, each iteration, and the bounds closing in.
#include <algorithm>
#include <cmath>

#include "render/drawing/drawn_pair.hpp"

namespace tumble {

using namespace render;

namespace {

constexpr int kWidth = 1280;
constexpr double kGap = 16.0;
constexpr double kTopHeight = 430.0;   // of the two large panels
constexpr double kStepHeight = 270.0;  // of one iteration's panel
constexpr int kMostColumns = 4;
constexpr double kCaptionSize = 12.0;

// The support vertices of a trace, numbered from 1 as they were first found.
class FoundVertices {
public:
    explicit FoundVertices(const DistanceTrace& trace) {
        if (trace.steps.empty()) return;
        const TraceStep& first = trace.steps.front();
        for (std::size_t i = 0; i < first.count; ++i) add(first.simplex[i], first.vertices[i]);
        for (const TraceStep& step : trace.steps) add(step.support, step.support_vertex);
    }

    // Vertices by two index pairs may lie in one place.
    std::string number(VertexPair pair) const {
        const auto at = std::ranges::find(pairs_, pair);
        return std::to_string(at - pairs_.begin() + 1);
    }
    const std::vector<DVec2>& places() const { return places_; }

private:
    void add(VertexPair pair, DVec2 place) {
        if (std::ranges::find(pairs_, pair) != pairs_.end()) return;
        pairs_.push_back(pair);
        places_.push_back(place);
    }

    std::vector<VertexPair> pairs_;
    std::vector<DVec2> places_;
};

// What all panels of one trace share.
struct TraceScene {
    const DrawnPair& pair;
    const DistanceTrace& trace;
    FoundVertices found;
    std::vector<DVec2> core;  // the outline of the cores' difference
    std::vector<DVec2> view;  // what each iteration's panel must hold
    bool is_zoomed = false;
};

double larger_side(const std::vector<DVec2>& points) {
    DVec2 lower = points.front(), upper = points.front();
    for (const DVec2 p : points) {
        lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
        upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
    }
    return std::max(upper.x - lower.x, upper.y - lower.y);
}

// The iterations are shown where they happen if that is a small part of the difference.
TraceScene make_scene(const DrawnPair& pair, const DistanceTrace& trace) {
    constexpr double kSmallPart = 0.5;
    TraceScene scene{pair, trace, FoundVertices(trace), pair.outline_difference(0.0), {}, false};
    scene.view = scene.core;
    scene.view.push_back({});
    std::vector<DVec2> near = scene.found.places();
    near.push_back({});
    const double size = larger_side(near);
    if (size > 0.0 && size < kSmallPart * larger_side(scene.view)) {
        scene.view = near;
        scene.is_zoomed = true;
    }
    return scene;
}

void draw_origin(Panel& panel, Drawing& drawing) {
    const DVec2 o = panel.to_pixels(DVec2{});
    drawing.line(o - DVec2{7.0, 0.0}, o + DVec2{7.0, 0.0}, 2.0, ink::kText);
    drawing.line(o - DVec2{0.0, 7.0}, o + DVec2{0.0, 7.0}, 2.0, ink::kText);
}

// Beside a point of the plane, in a direction of the plane of any length.
void draw_label_beside(Panel& panel, DVec2 at, DVec2 direction, const std::string& text, Color color) {
    constexpr double kAway = 16.0;
    const double reach = kAway + 3.0 * static_cast<double>(text.size() - 1), norm = std::max(length(direction), 1e-300);
    panel.label(at, {reach * direction.x / norm, 5.0 - kAway * direction.y / norm}, text, 13.0, color);
}

// A found vertex with its number: outside the difference, but not on the way to the origin.
void draw_vertex(Panel& panel, const TraceScene& scene, DVec2 w, const std::string& number) {
    constexpr double kInLine = 0.8;  // cosine
    panel.dot(w, 4.0, ink::kSimplex);
    DVec2 outwards = w - mean(scene.core);
    const DVec2 to_origin = -w;
    if (dot(outwards, to_origin) > kInLine * length(outwards) * length(to_origin)) outwards = -outwards;
    draw_label_beside(panel, w, outwards, number, ink::kSimplex);
}

// Each vertex once, and those too near to another one without their numbers: the iterations show them.
void draw_found_vertices(Panel& panel, const TraceScene& scene) {
    constexpr double kLegible = 16.0;  // px
    const std::vector<DVec2>& places = scene.found.places();
    for (std::size_t k = 0; k < places.size(); ++k) {
        const DVec2 at = panel.to_pixels(places[k]);
        const bool is_free = std::none_of(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(k),
                                          [&](DVec2 other) { return length(panel.to_pixels(other) - at) < kLegible; });
        if (is_free)
            draw_vertex(panel, scene, places[k], std::to_string(k + 1));
        else
            panel.dot(places[k], 4.0, ink::kSimplex);
    }
}

void draw_difference_panel(Drawing& drawing, PixelRect rect, const TraceScene& scene) {
    const DistanceResult& result = scene.trace.result;
    const double radius = scene.pair.radii();
    const std::vector<DVec2> grown = scene.pair.outline_difference(radius);
    std::vector<DVec2> view = grown;
    view.push_back({});
    const std::string caption =
        radius > 0.0 ? "GJK sees the cores; the thin outline adds both radii, " + short_number(radius) + " m" : "";
    Panel panel(drawing,
                draw_frame(drawing, rect, "Minkowski difference A - B: as far from the origin as A is from B", caption),
                view);
    if (radius > 0.0) panel.fill(grown, kTransparent, 1.0, ink::kFaint);
    panel.fill(scene.core, ink::kDifferenceFill, 2.0, ink::kDifference);
    draw_origin(panel, drawing);
    if (result.status == DistanceStatus::invalid) return;
    const DVec2 nearest = -(result.distance + radius) * result.normal;
    panel.line({}, nearest, 2.0, ink::kAnswer);
    draw_found_vertices(panel, scene);
    panel.dot(nearest, 4.5, ink::kAnswer);
    panel.label({}, {nearest.x > 0.0 ? -28.0 : 28.0, nearest.y > 0.0 ? 20.0 : -12.0}, "origin", kCaptionSize,
                ink::kText);
}

// What an iteration did, in one line.
std::string story(const TraceScene& scene, std::size_t k) {
    const TraceStep& step = scene.trace.steps[k];
    const std::string support = scene.found.number(step.support);
    const std::string v = step.count == 1 ? "v: vertex " + scene.found.number(step.simplex[0])
                                          : "v: between " + scene.found.number(step.simplex[0]) + " and " +
                                                scene.found.number(step.simplex[1]);
    const bool is_last = k + 1 == scene.trace.steps.size() && !scene.trace.result.certificate.cores_overlap;
    return v + "; support: " + support + (is_last ? ", no farther: done" : "");
}

void draw_step_panel(Drawing& drawing, PixelRect rect, const TraceScene& scene, std::size_t k) {
    const TraceStep& step = scene.trace.steps[k];
    const std::string title = std::to_string(k + 1) + ":  between " + short_number(std::max(0.0, step.lower)) +
                              " and |v| = " + short_number(step.upper);
    Panel panel(drawing, draw_frame(drawing, rect, title, story(scene, k)), scene.view);
    panel.fill(scene.core, ink::kDifferenceFill, 1.0, ink::kDifference);
    const DVec2 along =
        (2.0 * larger_side(scene.view) / std::max(length(step.direction), 1e-300)) * perp(step.direction);
    panel.line(step.support_vertex - along, step.support_vertex + along, 1.0, ink::kText);
    const std::vector<DVec2> simplex(step.vertices.begin(), step.vertices.begin() + step.count);
    panel.fill(simplex, ink::kSimplexFill, 3.0, ink::kSimplex);
    panel.dashed(step.closest, {}, 1.5, ink::kAnswer);
    panel.arrow(step.closest, step.direction, 32.0, ink::kAnswer);
    for (std::size_t i = 0; i < step.count; ++i)
        draw_vertex(panel, scene, step.vertices[i], scene.found.number(step.simplex[i]));
    panel.dot(step.closest, 4.0, ink::kAnswer);
    draw_vertex(panel, scene, step.support_vertex, scene.found.number(step.support));
    panel.ring(step.support_vertex, 7.0, ink::kText);
    draw_origin(panel, drawing);
}

// After the last support of overlapping cores: the simplex that holds the origin.
void draw_enclosing_panel(Drawing& drawing, PixelRect rect, const TraceScene& scene) {
    const TraceStep& last = scene.trace.steps.back();
    const PixelRect inner =
        draw_frame(drawing, rect, "The simplex holds the origin: overlap", "depth: to the nearest face of A - B");
    Panel panel(drawing, inner, scene.view);
    panel.fill(scene.core, ink::kDifferenceFill, 1.0, ink::kDifference);
    std::vector<DVec2> simplex(last.vertices.begin(), last.vertices.begin() + last.count);
    simplex.push_back(last.support_vertex);
    panel.fill(simplex, ink::kSimplexFill, 3.0, ink::kSimplex);
    for (std::size_t i = 0; i < last.count; ++i)
        draw_vertex(panel, scene, last.vertices[i], scene.found.number(last.simplex[i]));
    draw_vertex(panel, scene, last.support_vertex, scene.found.number(last.support));
    draw_origin(panel, drawing);
}

// Both bounds over the iterations, in a panel of its own.
void draw_bounds_panel(Drawing& drawing, PixelRect rect, const std::vector<TraceStep>& steps) {
    double top = 0.0, bottom = 0.0;
    for (const TraceStep& step : steps) top = std::max(top, step.upper);
    if (!(top > 0.0) || !std::isfinite(top)) top = 1.0;
    bottom = std::clamp(steps.front().lower, 0.0, top);
    if (bottom < 0.5 * top) bottom = 0.0;
    const double range = top > bottom ? top - bottom : 1.0;
    draw_frame(drawing, rect, "Bounds on the distance of the cores");
    const double left = rect.left + 64.0, right = rect.left + rect.width - 24.0;
    const double base = rect.top + rect.height - 48.0, height = rect.height - 96.0;
    const auto x = [&](std::size_t k) {
        return left + (right - left) * static_cast<double>(k) / static_cast<double>(steps.size() - 1);
    };
    const auto y = [&](double value) { return base - height * std::clamp((value - bottom) / range, 0.0, 1.0); };
    drawing.line({left, base}, {right, base}, 1.0, ink::kFaint);
    drawing.text({left - 8.0, base + 4.0}, short_number(bottom), kCaptionSize, ink::kText, TextAnchor::right);
    drawing.text({left - 8.0, base - height + 4.0}, short_number(top), kCaptionSize, ink::kText, TextAnchor::right);
    std::vector<DVec2> upper, lower;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        upper.push_back({x(k), y(steps[k].upper)});
        lower.push_back({x(k), y(steps[k].lower)});
        drawing.text({x(k), base + 18.0}, std::to_string(k + 1), kCaptionSize, ink::kText, TextAnchor::middle);
    }
    drawing.polyline(upper, 2.0, ink::kAnswer);
    drawing.polyline(lower, 2.0, ink::kText);
    for (const DVec2 p : upper) drawing.disc(p, 4.0, ink::kAnswer);
    for (const DVec2 p : lower) drawing.disc(p, 4.0, ink::kText);
    drawing.text({left, base + 37.0}, "below: the thin line", kCaptionSize, ink::kText);
    drawing.text({right, base + 37.0}, "above: |v|", kCaptionSize, ink::kAnswer, TextAnchor::right);
}

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
    const DrawnPair pair(a, world_from_a, b, world_from_b);
    const TraceScene scene = make_scene(pair, trace);
    const int steps = static_cast<int>(trace.steps.size());
    const bool encloses = trace.result.certificate.cores_overlap && steps > 0;
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
    draw_difference_panel(drawing, {2.0 * kGap + half, 48.0, half, kTopHeight}, scene);
    if (steps == 0) return drawing;

    drawing.text({kGap, steps_top - 30.0},
                 "Each iteration: the simplex (green), its point v nearest to the origin (red), the search direction "
                 "(arrow), and "
                 "the support vertex, farthest along it (ring).",
                 13.0, ink::kText);
    drawing.text({kGap, steps_top - 12.0},
                 std::string("Nothing of A - B lies beyond the thin line through it, which proves the lower bound.") +
                     (scene.is_zoomed ? " Shown where it happens: the difference goes on outside." : ""),
                 13.0, ink::kText);
    const double width = (kWidth - (columns + 1) * kGap) / columns;
    for (int k = 0; k < panels; ++k) {
        const PixelRect rect{kGap + k % columns * (width + kGap), steps_top + k / columns * (kStepHeight + kGap), width,
                             kStepHeight};
        if (k < steps)
            draw_step_panel(drawing, rect, scene, static_cast<std::size_t>(k));
        else if (encloses && k == steps)
            draw_enclosing_panel(drawing, rect, scene);
        else
            draw_bounds_panel(drawing, rect, trace.steps);
    }
    return drawing;
}

}  // namespace tumble
