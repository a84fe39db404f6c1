// Draws a distance query: the pair, its Minkowski difference, every iteration of GJK, and the bounds closing in.
//
// All vectors of a trace are in world axes relative to A's position, and so is everything drawn here: the picture of a
// pair 10 km out looks like the picture at the origin.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "render/panel.hpp"

namespace tumble {

using namespace render;

namespace {

constexpr int kWidth = 1280;
constexpr double kGap = 16.0;
constexpr double kTopHeight = 430.0;   // of the two large panels
constexpr double kStepHeight = 250.0;  // of one iteration's panel
constexpr int kStepColumns = 4;
constexpr double kPlotHeight = 210.0;

std::string number(double value) {
    value += 0.0;  // no negative zero
    std::array<char, 32> buffer{};
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 5);
    return error == std::errc() ? std::string(buffer.data(), end) : std::string("?");
}

std::string_view name(DistanceStatus status) {
    switch (status) {
        case DistanceStatus::separated: return "separated";
        case DistanceStatus::touching: return "touching";
        case DistanceStatus::overlapping: return "overlapping";
        case DistanceStatus::invalid: return "invalid";
    }
    return "";
}

// The two shapes, moved so that A's position is the origin, and the outlines that the panels show.
struct Pair {
    Pair(const Shape& shape_a, const Pose& world_from_a, const Shape& shape_b, const Pose& world_from_b)
        : a(shape_a), b(shape_b), pose_a{{}, world_from_a.rotation},
          pose_b{world_from_b.position - world_from_a.position, world_from_b.rotation}, origin(world_from_a.position) {}

    DVec2 support_a(DVec2 direction) const { return world_support(a, pose_a, direction); }
    DVec2 support_b(DVec2 direction) const { return world_support(b, pose_b, direction); }
    DVec2 support_difference(DVec2 direction) const { return support_a(direction) - support_b(-direction); }

    std::vector<DVec2> outline_a(double radius) const {
        return sampled_outline([this](DVec2 d) { return support_a(d); }, radius);
    }
    std::vector<DVec2> outline_b(double radius) const {
        return sampled_outline([this](DVec2 d) { return support_b(d); }, radius);
    }
    std::vector<DVec2> outline_difference(double radius) const {
        return sampled_outline([this](DVec2 d) { return support_difference(d); }, radius);
    }

    const Shape& a;
    const Shape& b;
    Pose pose_a, pose_b;  // relative to A's position
    DVec2 origin;         // A's position in the world
};

DVec2 mean(const std::vector<DVec2>& points) {
    DVec2 sum;
    for (const DVec2 p : points) sum += p;
    return (1.0 / static_cast<double>(points.size())) * sum;
}

void draw_shape(Panel& panel, const std::vector<DVec2>& outline, const std::vector<DVec2>& core, double radius, Color fill,
                Color line, const std::string& letter) {
    panel.fill(outline, fill, 2.0, line);
    if (radius > 0.0) panel.fill(core, kTransparent, 1.0, line);
    panel.label(mean(outline), {0.0, 7.0}, letter, 20.0, line);
}

void draw_shapes(Panel& panel, const Pair& pair, const DistanceResult& result) {
    draw_shape(panel, pair.outline_a(pair.a.radius()), pair.outline_a(0.0), pair.a.radius(), ink::kShapeAFill, ink::kShapeA, "A");
    draw_shape(panel, pair.outline_b(pair.b.radius()), pair.outline_b(0.0), pair.b.radius(), ink::kShapeBFill, ink::kShapeB, "B");
    if (result.status == DistanceStatus::invalid) return;
    const DVec2 point_a = result.point_a - pair.origin, point_b = result.point_b - pair.origin;
    panel.line(point_a, point_b, 2.0, ink::kAnswer);
    panel.dot(point_a, 4.5, ink::kShapeA);
    panel.dot(point_b, 4.5, ink::kShapeB);
    panel.arrow(point_a, result.normal, 42.0, ink::kAnswer);
}

void draw_pair_panel(Drawing& drawing, PixelRect rect, const Pair& pair, const DistanceResult& result) {
    std::vector<DVec2> all = pair.outline_a(pair.a.radius());
    const std::vector<DVec2> b = pair.outline_b(pair.b.radius());
    all.insert(all.end(), b.begin(), b.end());
    Panel panel(drawing, rect, all);
    panel.frame("The shapes, with their closest (or deepest) points");
    draw_shapes(panel, pair, result);
}

// The surroundings of the contact: a few times the distance, but no less than a thousandth of the smaller shape.
void draw_contact_panel(Drawing& drawing, PixelRect rect, const Pair& pair, const DistanceResult& result,
                        std::span<const DVec2> rings) {
    const double smaller = std::min(extent(pair.a).larger, extent(pair.b).larger);
    const double reach = std::max(4.0 * std::abs(result.distance), 1e-3 * smaller);
    const DVec2 middle = 0.5 * ((result.point_a - pair.origin) + (result.point_b - pair.origin));
    const std::array<DVec2, 2> corners = {middle - DVec2{reach, reach}, middle + DVec2{reach, reach}};
    Panel panel(drawing, rect, corners);
    panel.frame("At the contact, " + number(2.0 * reach) + " m high");
    draw_shapes(panel, pair, result);
    for (const DVec2 ring : rings) panel.ring(ring - pair.origin, 8.0, ink::kText);
}

void draw_origin(Panel& panel, Drawing& drawing) {
    const DVec2 o = panel.to_pixels(DVec2{});
    drawing.line(o - DVec2{7.0, 0.0}, o + DVec2{7.0, 0.0}, 2.0, ink::kText);
    drawing.line(o - DVec2{0.0, 7.0}, o + DVec2{0.0, 7.0}, 2.0, ink::kText);
}

// The difference of the cores and the origin, with whatever else a panel must keep in view.
std::vector<DVec2> difference_view(const std::vector<DVec2>& outline) {
    std::vector<DVec2> view = outline;
    view.push_back({});
    return view;
}

void label_vertex(Panel& panel, DVec2 w, const std::vector<DVec2>& core, const std::string& label) {
    panel.dot(w, 4.0, ink::kSimplex);
    const DVec2 outwards = w - mean(core);
    const double norm = std::max(length(outwards), 1e-300);
    const double reach = label.size() > 2 ? 26.0 : 16.0;
    panel.label(w, {reach * outwards.x / norm, 5.0 - 14.0 * outwards.y / norm}, label, 13.0, ink::kSimplex);
}

void draw_difference_panel(Drawing& drawing, PixelRect rect, const Pair& pair, const DistanceTrace& trace) {
    const double radius = double{pair.a.radius()} + double{pair.b.radius()};
    const std::vector<DVec2> core = pair.outline_difference(0.0), grown = pair.outline_difference(radius);
    Panel panel(drawing, rect, difference_view(grown));
    panel.frame("Minkowski difference A - B: its distance from the origin is theirs");
    if (radius > 0.0) panel.fill(grown, kTransparent, 1.0, ink::kFaint);
    panel.fill(core, ink::kDifferenceFill, 2.0, ink::kDifference);
    draw_origin(panel, drawing);
    panel.label({}, {0.0, 24.0}, "origin", 12.0, ink::kText);
    if (trace.result.status == DistanceStatus::invalid) return;
    const DVec2 nearest = -(trace.result.distance + radius) * trace.result.normal;
    panel.line({}, nearest, 2.0, ink::kAnswer);
    if (!trace.steps.empty() && trace.steps[0].count == 1) label_vertex(panel, trace.steps[0].vertices[0], core, "start");
    for (std::size_t k = 0; k < trace.steps.size(); ++k) {
        const DVec2 w = trace.steps[k].support_vertex;
        const bool seen = std::any_of(trace.steps.begin(), trace.steps.begin() + static_cast<std::ptrdiff_t>(k),
                                      [w](const TraceStep& step) { return step.support_vertex == w; });
        if (seen) continue;
        if (k == 0 || !(w == trace.steps[0].vertices[0])) label_vertex(panel, w, core, std::to_string(k + 1));
    }
    panel.dot(nearest, 4.5, ink::kAnswer);
}

void draw_step_panel(Drawing& drawing, PixelRect rect, const std::vector<DVec2>& core, const TraceStep& step, int number_of_step) {
    Panel panel(drawing, rect, difference_view(core));
    panel.frame(std::to_string(number_of_step) + ":  |v| = " + number(step.upper) + ",  at least " + number(std::max(0.0, step.lower)));
    panel.fill(core, ink::kDifferenceFill, 1.0, ink::kDifference);
    const std::vector<DVec2> simplex(step.vertices.begin(), step.vertices.begin() + step.count);
    panel.fill(simplex, ink::kSimplexFill, 3.0, ink::kSimplex);
    for (const DVec2 w : simplex) panel.dot(w, 4.0, ink::kSimplex);
    panel.dashed(step.closest, {}, 1.5, ink::kAnswer);
    panel.dot(step.closest, 4.0, ink::kAnswer);
    panel.arrow(step.closest, step.direction, 36.0, ink::kAnswer);
    const DVec2 w = panel.to_pixels(step.support_vertex);
    drawing.disc(w, 7.0, kTransparent, 2.0, ink::kText);
    draw_origin(panel, drawing);
}

// After the last support of overlapping cores: the simplex that holds the origin.
void draw_enclosing_panel(Drawing& drawing, PixelRect rect, const std::vector<DVec2>& core, const TraceStep& last) {
    Panel panel(drawing, rect, difference_view(core));
    panel.frame("The simplex holds the origin: overlap");
    panel.fill(core, ink::kDifferenceFill, 1.0, ink::kDifference);
    std::vector<DVec2> simplex(last.vertices.begin(), last.vertices.begin() + last.count);
    simplex.push_back(last.support_vertex);
    panel.fill(simplex, ink::kSimplexFill, 3.0, ink::kSimplex);
    for (const DVec2 w : simplex) panel.dot(w, 4.0, ink::kSimplex);
    draw_origin(panel, drawing);
}

void draw_bounds_plot(Drawing& drawing, PixelRect rect, const DistanceTrace& trace) {
    const std::vector<TraceStep>& steps = trace.steps;
    double top = 0.0;
    for (const TraceStep& step : steps) top = std::max(top, step.upper);
    if (!(top > 0.0) || !std::isfinite(top)) top = 1.0;
    drawing.text({rect.left + 8.0, rect.top + 19.0}, "Bounds on the distance of the cores, by iteration", 13.0, ink::kText);
    const double left = rect.left + 70.0, right = rect.left + rect.width - 30.0;
    const double base = rect.top + rect.height - 34.0, height = rect.height - 78.0;
    const auto x = [&](std::size_t k) {
        return steps.size() < 2 ? 0.5 * (left + right) : left + (right - left) * static_cast<double>(k) / static_cast<double>(steps.size() - 1);
    };
    const auto y = [&](double value) { return base - height * std::clamp(value / top, 0.0, 1.0); };
    drawing.line({left, base}, {right, base}, 1.0, ink::kFaint);
    drawing.text({left - 10.0, base + 5.0}, "0", 12.0, ink::kText, TextAnchor::right);
    drawing.text({left - 10.0, base - height + 5.0}, number(top), 12.0, ink::kText, TextAnchor::right);
    std::vector<DVec2> upper, lower;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        upper.push_back({x(k), y(steps[k].upper)});
        lower.push_back({x(k), y(steps[k].lower)});
        drawing.text({x(k), base + 20.0}, std::to_string(k + 1), 12.0, ink::kText, TextAnchor::middle);
    }
    drawing.polyline(upper, 2.0, ink::kAnswer);
    drawing.polyline(lower, 2.0, ink::kSimplex);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        drawing.disc(upper[k], 4.0, ink::kAnswer);
        drawing.disc(lower[k], 4.0, ink::kSimplex);
    }
    drawing.text({right, rect.top + 19.0}, "upper bound |v|", 12.0, ink::kAnswer, TextAnchor::right);
    drawing.text({right - 130.0, rect.top + 19.0}, "lower bound", 12.0, ink::kSimplex, TextAnchor::right);
}

std::string summary(const DistanceResult& result) {
    if (result.status == DistanceStatus::invalid) return "invalid input";
    return std::string(name(result.status)) + ": signed distance " + number(result.distance) + " m, normal (" +
           number(result.normal.x) + ", " + number(result.normal.y) + "), " + std::to_string(result.iterations) + " iterations";
}

}  // namespace

Drawing draw_pair(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                  const DistanceResult& result, std::span<const DVec2> rings) {
    Drawing drawing;
    drawing.width = kWidth;
    drawing.height = static_cast<int>(kTopHeight + 2.0 * kGap);
    const Pair pair(a, world_from_a, b, world_from_b);
    const double half = 0.5 * (kWidth - 3.0 * kGap);
    draw_pair_panel(drawing, {kGap, kGap, half, kTopHeight}, pair, result);
    if (result.status != DistanceStatus::invalid)
        draw_contact_panel(drawing, {2.0 * kGap + half, kGap, half, kTopHeight}, pair, result, rings);
    return drawing;
}

Drawing draw_trace(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                   const DistanceTrace& trace) {
    const Pair pair(a, world_from_a, b, world_from_b);
    const bool encloses = trace.result.certificate.cores_overlap && !trace.steps.empty();
    const int panels = static_cast<int>(trace.steps.size()) + (encloses ? 1 : 0);
    const int rows = (panels + kStepColumns - 1) / kStepColumns;
    const double steps_top = 48.0 + kTopHeight + kGap + 28.0;
    const double plot_top = steps_top + rows * (kStepHeight + kGap);
    Drawing drawing;
    drawing.width = kWidth;
    drawing.height = static_cast<int>(plot_top + kPlotHeight + kGap);

    drawing.text({kGap, 32.0}, summary(trace.result), 18.0, ink::kText);
    const double half = 0.5 * (kWidth - 3.0 * kGap);
    draw_pair_panel(drawing, {kGap, 48.0, half, kTopHeight}, pair, trace.result);
    draw_difference_panel(drawing, {2.0 * kGap + half, 48.0, half, kTopHeight}, pair, trace);

    drawing.text({kGap, steps_top - 12.0},
                 "Each iteration: the simplex (green), its point v nearest to the origin (red), the search direction, "
                 "and the support vertex found (ring)",
                 13.0, ink::kText);
    const std::vector<DVec2> core = pair.outline_difference(0.0);
    const double step_width = (kWidth - (kStepColumns + 1) * kGap) / kStepColumns;
    for (int k = 0; k < panels; ++k) {
        const int column = k % kStepColumns, row = k / kStepColumns;
        const PixelRect rect{kGap + column * (step_width + kGap), steps_top + row * (kStepHeight + kGap), step_width, kStepHeight};
        if (k < static_cast<int>(trace.steps.size()))
            draw_step_panel(drawing, rect, core, trace.steps[static_cast<std::size_t>(k)], k + 1);
        else
            draw_enclosing_panel(drawing, rect, core, trace.steps.back());
    }
    draw_bounds_plot(drawing, {kGap, plot_top, kWidth - 2.0 * kGap, kPlotHeight}, trace);
    return drawing;
}

}  // namespace tumble
