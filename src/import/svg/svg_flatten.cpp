// Curves are divided at equal steps of their parameter. The chord over a step h is at most h^2 / 8 times the largest
// second derivative from the curve, which gives the number of steps. Affine maps take Bezier curves to Bezier curves
// and ellipses to ellipses, so curves are mapped first and the tolerance holds in the world.
#include "import/svg/svg_flatten.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "import/svg/svg_text.hpp"
#include "scene/format/fields.hpp"
#include "scene/json/json_text.hpp"

namespace tumble::scene {

namespace {

constexpr std::size_t kMostPoints = 65535;  // of one element, as of one list in a scene file

// Points nearer to each other than this fraction of the tolerance are one point.
constexpr double kCoincident = 1e-3;

// The longer half axis of an ellipse given by two conjugate half diameters: the larger singular value of (u v).
double longest_half_axis(DVec2 u, DVec2 v) {
    const double uu = length_sq(u), vv = length_sq(v), uv = dot(u, v);
    return std::sqrt(0.5 * (uu + vv + std::sqrt((uu - vv) * (uu - vv) + 4.0 * uv * uv)));
}

}  // namespace

void Flattener::move_to(DVec2 point) {
    contours_.emplace_back();
    add(apply(map_, point));
}

void Flattener::line_to(DVec2 point) { add(apply(map_, point)); }

void Flattener::quadratic_to(DVec2 control, DVec2 point) {
    const DVec2 p0 = contours_.back().points.back(), p1 = apply(map_, control), p2 = apply(map_, point);
    const double second = 2.0 * length(p0 - 2.0 * p1 + p2);
    const std::size_t chords = chord_count(std::sqrt(second / (8.0 * tolerance_)));
    for (std::size_t i = 1; i < chords; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(chords), s = 1.0 - t;
        add(s * s * p0 + 2.0 * s * t * p1 + t * t * p2);
    }
    add(p2);
}

void Flattener::cubic_to(DVec2 control, DVec2 other_control, DVec2 point) {
    const DVec2 p0 = contours_.back().points.back(), p1 = apply(map_, control), p2 = apply(map_, other_control);
    const DVec2 p3 = apply(map_, point);
    const double second = 6.0 * std::max(length(p0 - 2.0 * p1 + p2), length(p1 - 2.0 * p2 + p3));
    const std::size_t chords = chord_count(std::sqrt(second / (8.0 * tolerance_)));
    for (std::size_t i = 1; i < chords; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(chords), s = 1.0 - t;
        add(s * s * s * p0 + 3.0 * s * s * t * p1 + 3.0 * s * t * t * p2 + t * t * t * p3);
    }
    add(p3);
}

void Flattener::arc_to(const EllipseArc& arc, DVec2 point) {
    const DVec2 center = apply(map_, arc.center), u = apply_linear(map_, arc.x_axis),
                v = apply_linear(map_, arc.y_axis);
    // The second derivative with respect to the angle is at most the longest half axis. A step is at most an eighth of
    // a turn.
    const double step = std::min(std::sqrt(8.0 * tolerance_ / longest_half_axis(u, v)), kPi / 4.0);
    const std::size_t chords = chord_count(std::abs(arc.turn) / step);
    for (std::size_t i = 1; i < chords; ++i) {
        const SinCos q = sin_cos(arc.start + arc.turn * static_cast<double>(i) / static_cast<double>(chords));
        add(center + q.cos * u + q.sin * v);
    }
    add(apply(map_, point));
}

void Flattener::close() { contours_.back().closed = true; }

std::size_t Flattener::chord_count(double chords) const {
    if (!(chords < static_cast<double>(kMostPoints)))
        throw SvgError("a curve needs more than " + std::to_string(kMostPoints) + " chords for a tolerance of " +
                       number_text(tolerance_) + " m");
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(chords)));
}

void Flattener::add(DVec2 world_point) {
    if (!(std::max(std::abs(world_point.x), std::abs(world_point.y)) <= kLargest))
        throw SvgError("a point is farther than " + number_text(kLargest) + " m from the origin");
    if (++count_ > kMostPoints) throw SvgError("the element has more than " + std::to_string(kMostPoints) + " points");
    std::vector<DVec2>& points = contours_.back().points;
    if (points.empty() || length(world_point - points.back()) > kCoincident * tolerance_) points.push_back(world_point);
}

std::vector<Contour> Flattener::take() {
    for (Contour& contour : contours_) {
        std::vector<DVec2>& points = contour.points;
        if (points.size() > 1 && length(points.back() - points.front()) <= kCoincident * tolerance_) {
            points.pop_back();
            contour.closed = true;
        }
        contour.closed = contour.closed && points.size() > 2;
    }
    std::erase_if(contours_, [](const Contour& contour) { return contour.points.size() < 2; });
    return std::move(contours_);
}

}  // namespace tumble::scene
