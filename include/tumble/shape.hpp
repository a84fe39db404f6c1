// Shapes: the convex hull of n >= 1 core vertices, grown by a radius.
//
// One type serves every pair: n = 1 is a circle, n = 2 a capsule (radius 0: a two-sided segment), n >= 3 a polygon,
// rounded if its radius is positive. GJK works on the cores; radii are subtracted last.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "tumble/math.hpp"

namespace tumble {

// The vertices of a polygon with more than Shape::kInlineVertices of them; immutable, shared between copies.
struct LargePolygon {
    std::vector<float> x;  // [n], counter-clockwise
    std::vector<float> y;  // [n]
    // [n], ascending from `first_edge` on, 0 to 4 around the circle. Empty if the outline is not strictly convex: a
    // support query then inspects all vertices.
    std::vector<double> edge_angles;
    std::int32_t first_edge = 0;
    // [2 n + 1], the number of edges before each of 2 n equal parts of the circle.
    std::vector<std::uint16_t> edges_before;
};

// The points given to make_polygon(), counted by their relation to the hull. `kept + duplicate + collinear + interior`
// is their number.
struct HullReport {
    int kept = 0;
    int duplicate = 0;  // within the weld distance of a kept vertex
    int collinear = 0;  // on an edge, within the weld distance
    int interior = 0;   // farther inside the hull: the outline given was concave, or had stray points
};

class Shape {
public:
    static constexpr int kInlineVertices = 8;
    static constexpr int kMaxVertices = 65535;

    // An empty shape: no vertices. Queries answer `invalid` for it, a world refuses it.
    Shape() = default;

    int vertex_count() const noexcept { return count_; }
    float radius() const noexcept { return radius_; }

    // True if the outline is convex and counter-clockwise, decided exactly: no vertex lies to the right of an edge, and
    // for n > 8 none lies on the line of an edge that it does not end. If it is false, distance queries answer for the
    // hull, and casts, times of impact and manifolds are wrong.
    bool is_convex() const noexcept { return is_convex_; }

    // The largest distance of a core vertex from the local origin (m), correct to a few ulp; not finite if a vertex is
    // not. The error bounds of the narrow phase are relative to it.
    double core_radius() const noexcept { return core_radius_; }

    // Core vertices in local coordinates (m), [vertex_count()], counter-clockwise for n >= 3. For n <= 8 the arrays
    // behind the spans have 8 entries, padded with vertex 0, so that lanes may read them all.
    std::span<const float> x() const noexcept { return {large_ ? large_->x.data() : x_, size()}; }
    std::span<const float> y() const noexcept { return {large_ ? large_->y.data() : y_, size()}; }
    Vec2 vertex(int index) const noexcept {
        const auto i = static_cast<std::size_t>(index);
        return {x()[i], y()[i]};
    }

    // The vertices of a shape with n > 8; null for n <= 8.
    const LargePolygon* large() const noexcept { return large_.get(); }

    // True if both have the same vertices in the same order and the same radius.
    friend bool operator==(const Shape& a, const Shape& b) noexcept;

    // The shape with exactly these core vertices: no hull, no welding. More than kMaxVertices throw
    // std::invalid_argument; nothing else is checked. For callers that have a convex, counter-clockwise outline: see
    // is_convex() for others. If a vertex is not finite, or the radius is negative or not finite, all queries are
    // `invalid`.
    static Shape from_raw(std::span<const Vec2> vertices, float radius);

private:
    std::size_t size() const noexcept { return static_cast<std::size_t>(count_); }

    std::uint16_t count_ = 0;
    bool is_convex_ = true;
    float radius_ = 0.0f;
    double core_radius_ = 0.0;
    float x_[kInlineVertices] = {};
    float y_[kInlineVertices] = {};
    std::shared_ptr<const LargePolygon> large_;
};

// The factories. Points and lengths are in m, in the shape's own coordinates. All factories throw
// std::invalid_argument, with the offending value printed, for numbers that are not finite, for a negative radius, and
// for the errors that their comments name.

Shape make_circle(float radius, Vec2 center = {});     // radius 0: a point
Shape make_capsule(Vec2 from, Vec2 to, float radius);  // from == to gives a circle
Shape make_segment(Vec2 from, Vec2 to);                // a capsule without radius: two-sided

// A box of outer size `size` (both > 0) whose corners are rounded by `radius` (at most half the smaller side). The core
// has the size minus 2 radius; if a side of the core is 0, the result is a capsule or a circle. The box is rotated
// about its center by `angle` (radians, at most 1e6). A box so far from the origin that its corners coincide in float
// is an error.
Shape make_box(Vec2 size, float radius = 0.0f, Vec2 center = {}, double angle = 0.0);

// The convex hull of `points`, one or more, in any order; the radius grows it. The first vertex is the lowest of the
// leftmost ones. Vertices that lie within t = kWeldTolerance times the larger side of the points' bounding box of the
// edge that replaces them are dropped, which also welds points closer than t: no point lies farther than t outside the
// result. The report, if given, counts them. If all points are equal or on a line, the result has 1 or 2 vertices: a
// circle or a capsule. More than 65 535 vertices after that are an error.
Shape make_polygon(std::span<const Vec2> points, float radius = 0.0f, HullReport* report = nullptr);

// Relative to the larger side of the points' bounding box: a few ulp of float, far below any visible feature.
inline constexpr float kWeldTolerance = 1e-6f;

// The exact convex hull of `points`, one or more, in any order; the radius grows it. Unlike make_polygon() it welds and
// drops nothing: every point at which the hull turns is a vertex, however little it turns there, and every decision is
// exact. Use it for distance queries whose bounds must hold for the points as given, and make_polygon() for bodies,
// since its polygons have no edges of a few ulp. The first vertex is the lowest of the leftmost ones. Equal points give
// a circle, points on a line the capsule between their two extreme points. More than 65 535 vertices are an error.
Shape make_exact_polygon(std::span<const Vec2> points, float radius = 0.0f);

// Segments between consecutive points, [n - 1], or [n] if `loop` closes the chain. Fewer than two points are an error.
std::vector<Shape> make_chain(std::span<const Vec2> points, bool loop);

struct MassProperties {
    double area = 0.0;     // m^2, of the core grown by the radius; 0 for a point or a segment
    Vec2 center;           // centroid in local coordinates; the middle of the core's bounding box if the area is 0
    double inertia = 0.0;  // second moment of area about the centroid, m^4: times density gives kg m^2
};

// Exact formulas for polygon, edge strips and corner sectors, evaluated in double. All 0 for a shape without vertices.
MassProperties mass_properties(const Shape& shape);

// The box around the shape at the pose, radius included, rounded outwards. Empty for a shape without vertices and for
// input that is not finite.
Aabb bounds(const Shape& shape, const Pose& world_from_shape);

// The larger and the smaller side of the local bounding box, radius included (m); 0 and 0 for a shape without vertices.
struct Extent {
    float larger = 0.0f;
    float smaller = 0.0f;
};
Extent extent(const Shape& shape);

// The distance of the farthest point of the shape, radius included, from the local point (m), rounded upwards.
float farthest_distance(const Shape& shape, Vec2 from);

}  // namespace tumble
