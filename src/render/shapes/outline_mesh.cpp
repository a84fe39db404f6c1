#include "render/shapes/outline_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "debug/check.hpp"
#include "render/shapes/mitre.hpp"
#include "render/style/style.hpp"
#include "render/view/clip.hpp"

namespace tumble::render {
namespace {

constexpr double kChordError = 0.05;   // pixels
constexpr double kMostChords = 65536;  // of an arc: enough up to a radius of 4e7 pixels
constexpr double kLeastSpacing = 0.5;  // pixels
constexpr double kOuterDepth = 1.0;    // pixels outside the edge, where coverage is 0

// Appends the arc about `center` from one direction (radians) through `turn` more.
void append_arc(std::vector<DVec2>& outline, DVec2 center, double radius, double from, double turn) {
    // A chord of angle a lies radius (1 - cos(a/2)) ~ radius a^2 / 8 off its arc.
    const double largest = std::sqrt(8.0 * kChordError / std::max(radius, kChordError));
    TUMBLE_CHECK(radius >= 0.0);
    const int chords = static_cast<int>(std::clamp(std::ceil(turn / largest), 1.0, kMostChords));
    for (int i = 0; i <= chords; ++i) {
        const SinCos direction = sin_cos(from + turn * i / chords);
        outline.push_back(center + radius * DVec2{direction.cos, direction.sin});
    }
}

// The core grown by a radius: an arc about each vertex, from the normal of the edge before to that of the edge after.
std::vector<DVec2> rounded(const std::vector<DVec2>& core, double radius) {
    std::vector<DVec2> outline;
    const std::size_t count = core.size();
    TUMBLE_CHECK(count >= 1);
    if (count == 1) {
        append_arc(outline, core[0], radius, 0.0, 2.0 * kPi);
        outline.pop_back();
        return outline;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const DVec2 before = right_normal(core[(i + count - 1) % count], core[i]);
        const DVec2 after = right_normal(core[i], core[(i + 1) % count]);
        const double from = arc_tangent(before.y, before.x);
        const double turn = count == 2 ? kPi : arc_tangent(cross(before, after), dot(before, after));
        append_arc(outline, core[i], radius, from, std::max(turn, 0.0));
    }
    return outline;
}

// The least distance of the mean of the points from an edge: an offset inwards by less keeps the outline convex.
double depth_of_middle(std::span<const DVec2> outline) {
    DVec2 middle;
    for (const DVec2 point : outline) middle += point;
    middle = (1.0 / static_cast<double>(outline.size())) * middle;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const DVec2 next = outline[(i + 1) % outline.size()];
        least = std::min(least, dot(right_normal(outline[i], next), next - middle));
    }
    return least;
}

}  // namespace

std::vector<DVec2> thinned(const std::vector<DVec2>& outline) {
    std::vector<DVec2> kept;
    for (const DVec2 point : outline)
        if (kept.empty() || length(point - kept.back()) >= kLeastSpacing) kept.push_back(point);
    while (kept.size() > 1 && length(kept.back() - kept.front()) < kLeastSpacing) kept.pop_back();
    return kept;
}

std::vector<DVec2> pixel_outline(const View& view, const Shape& shape, const Pose& pose) {
    std::vector<DVec2> core(static_cast<std::size_t>(shape.vertex_count()));
    for (std::size_t i = 0; i < core.size(); ++i)
        core[i] = view.to_pixels(transform_point(pose, shape.vertex(static_cast<int>(i))));
    const double radius = view.scale * shape.radius();
    return thinned(radius > 0.0 ? rounded(core, radius) : core);
}

void add_outline_mesh(std::vector<MeshVertex>& mesh, const View& view, const Shape& shape, const Pose& pose,
                      Paint paint) {
    const std::vector<DVec2> outline = clip_polygon(view, kClipMargin, pixel_outline(view, shape, pose));
    add_convex_mesh(mesh, outline, style::kOutline * view.detail(), paint);
}

void add_convex_mesh(std::vector<MeshVertex>& mesh, std::span<const DVec2> polygon, double outline_width, Paint paint) {
    if (polygon.size() < 3) return;
    const std::vector<DVec2> mitre = mitres(polygon, true);
    const double inner = std::min(outline_width + kOuterDepth, depth_of_middle(polygon));
    if (inner < kOuterDepth) paint = flat(paint.fill);  // too small to show an outline

    const auto vertex = [&](std::size_t i, double depth) {
        const DVec2 at = polygon[i] + depth * mitre[i];
        return MeshVertex{static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(depth), paint};
    };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t next = (i + 1) % polygon.size();
        const MeshVertex corners[4] = {vertex(i, kOuterDepth), vertex(next, kOuterDepth), vertex(i, -inner),
                                       vertex(next, -inner)};
        for (const int corner : {0, 1, 2, 2, 1, 3}) mesh.push_back(corners[corner]);
    }
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        for (const std::size_t corner : {std::size_t{0}, i, i + 1}) mesh.push_back(vertex(corner, -inner));
    TUMBLE_CHECK(mesh.size() % 3 == 0);
}

}  // namespace tumble::render
