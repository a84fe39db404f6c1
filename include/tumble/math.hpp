// Vectors, rotations, poses and bounding boxes: the small types of the whole library.
//
// SI units, y up, counter-clockwise positive, right-handed. Shapes, rotations and velocities are float; positions are
// double, so that a 1 m shape stays exact 10 km from the origin. All types are trivially copyable values.
#pragma once

#include <cmath>
#include <limits>

namespace tumble {

inline constexpr double kPi = 3.141592653589793238462643383279502884;

// A vector or point in float, for shapes, velocities and boxes.
struct Vec2 {
    float x = 0.0f;
    float y = 0.0f;

    friend constexpr bool operator==(Vec2, Vec2) = default;
};

// A vector or point in double, for positions in the world.
struct DVec2 {
    double x = 0.0;
    double y = 0.0;

    constexpr DVec2() = default;
    constexpr DVec2(double x_, double y_) : x(x_), y(y_) {}
    constexpr explicit DVec2(Vec2 v) : x(v.x), y(v.y) {}

    friend constexpr bool operator==(DVec2, DVec2) = default;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator-(Vec2 v) { return {-v.x, -v.y}; }
constexpr Vec2 operator*(float s, Vec2 v) { return {s * v.x, s * v.y}; }
constexpr Vec2& operator+=(Vec2& a, Vec2 b) { return a = a + b; }
constexpr Vec2& operator-=(Vec2& a, Vec2 b) { return a = a - b; }

constexpr DVec2 operator+(DVec2 a, DVec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr DVec2 operator-(DVec2 a, DVec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr DVec2 operator-(DVec2 v) { return {-v.x, -v.y}; }
constexpr DVec2 operator*(double s, DVec2 v) { return {s * v.x, s * v.y}; }
constexpr DVec2& operator+=(DVec2& a, DVec2 b) { return a = a + b; }
constexpr DVec2& operator-=(DVec2& a, DVec2 b) { return a = a - b; }

constexpr float dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
constexpr double dot(DVec2 a, DVec2 b) { return a.x * b.x + a.y * b.y; }

// The z component of the three-dimensional cross product: positive if b lies counter-clockwise of a.
constexpr float cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
constexpr double cross(DVec2 a, DVec2 b) { return a.x * b.y - a.y * b.x; }

// The velocity of a point at offset r (m) from the centre of a rotation with angular velocity w (rad/s).
constexpr Vec2 cross(float w, Vec2 r) { return {-w * r.y, w * r.x}; }
constexpr DVec2 cross(double w, DVec2 r) { return {-w * r.y, w * r.x}; }

// The vector rotated by 90 degrees counter-clockwise; the right-hand normal of an edge is -perp(edge).
constexpr Vec2 perp(Vec2 v) { return {-v.y, v.x}; }
constexpr DVec2 perp(DVec2 v) { return {-v.y, v.x}; }

constexpr float length_sq(Vec2 v) { return dot(v, v); }
constexpr double length_sq(DVec2 v) { return dot(v, v); }
inline float length(Vec2 v) { return std::sqrt(length_sq(v)); }
inline double length(DVec2 v) { return std::sqrt(length_sq(v)); }

constexpr Vec2 to_float(DVec2 v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

inline bool is_finite(Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); }
inline bool is_finite(DVec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); }

// A rotation as cosine and sine of its angle. Queries use c and s as they are: c^2 + s^2 may differ from 1 by rounding.
struct Rotation {
    float c = 1.0f;
    float s = 0.0f;

    friend constexpr bool operator==(Rotation, Rotation) = default;
};

constexpr Vec2 rotate(Rotation q, Vec2 v) { return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y}; }
constexpr Vec2 inverse_rotate(Rotation q, Vec2 v) { return {q.c * v.x + q.s * v.y, q.c * v.y - q.s * v.x}; }
constexpr DVec2 rotate(Rotation q, DVec2 v) {
    const double c = q.c, s = q.s;
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}
constexpr DVec2 inverse_rotate(Rotation q, DVec2 v) {
    const double c = q.c, s = q.s;
    return {c * v.x + s * v.y, c * v.y - s * v.x};
}

// Sine, cosine and arc tangent with the same bits on every platform, unlike those of the C library.
struct SinCos {
    double sin = 0.0;
    double cos = 1.0;
};

// Absolute error below 4e-16 for |radians| <= 1e6; NaN beyond, and for an angle that is not finite.
SinCos sin_cos(double radians);

// The same for an angle in degrees, of any finite size; multiples of 90 are exact.
SinCos sin_cos_degrees(double degrees);

// The angle of the vector (x, y), rad in (-pi, pi], relative error below 6e-16; 0 for (0, 0), NaN if not finite.
double arc_tangent(double y, double x);

// The rotation by an angle, rounded to float. Degrees may be any finite number, and multiples of 90 are exact. NaN for
// |radians| > 1e6 and for an angle that is not finite.
Rotation make_rotation(double radians);
Rotation make_rotation_degrees(double degrees);

// The angle of a rotation, radians in (-pi, pi]; 0 if c and s are 0, NaN if one is not finite.
double angle(Rotation q);

// Position and rotation of a body: maps local to world coordinates, p = position + rotate(rotation, local).
struct Pose {
    DVec2 position;
    Rotation rotation;

    friend constexpr bool operator==(const Pose&, const Pose&) = default;
};

// The world point of a local point, computed in double.
constexpr DVec2 transform_point(const Pose& world_from_local, DVec2 local) {
    return world_from_local.position + rotate(world_from_local.rotation, local);
}
constexpr DVec2 transform_point(const Pose& world_from_local, Vec2 local) {
    return transform_point(world_from_local, DVec2(local));
}

// The local point of a world point (for a rotation of unit length), computed in double.
constexpr DVec2 inverse_transform_point(const Pose& world_from_local, DVec2 world) {
    return inverse_rotate(world_from_local.rotation, world - world_from_local.position);
}

// An axis-aligned box in float, world coordinates. A box computed from doubles is rounded outwards, so that it contains
// its object far from the origin too. The default box is empty: its lower corner is above its upper one.
struct Aabb {
    Vec2 lower{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
    Vec2 upper{-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};

    friend constexpr bool operator==(const Aabb&, const Aabb&) = default;
};

// The smallest box that contains both; merged with the empty box, a box stays as it is.
constexpr Aabb merge(const Aabb& a, const Aabb& b) {
    return {{a.lower.x < b.lower.x ? a.lower.x : b.lower.x, a.lower.y < b.lower.y ? a.lower.y : b.lower.y},
            {a.upper.x > b.upper.x ? a.upper.x : b.upper.x, a.upper.y > b.upper.y ? a.upper.y : b.upper.y}};
}

// The box with all its sides moved outwards by `margin` (m).
constexpr Aabb enlarged(const Aabb& box, float margin) {
    return {box.lower - Vec2{margin, margin}, box.upper + Vec2{margin, margin}};
}

// True if the boxes overlap or touch. Without branches, as it is unpredictable which of the comparisons fails.
constexpr bool overlaps(const Aabb& a, const Aabb& b) {
    return bool((a.lower.x <= b.upper.x) & (b.lower.x <= a.upper.x) & (a.lower.y <= b.upper.y) &
                (b.lower.y <= a.upper.y));
}

// True if `inner` is inside `outer`; equal sides count as inside.
constexpr bool contains(const Aabb& outer, const Aabb& inner) {
    return outer.lower.x <= inner.lower.x && outer.lower.y <= inner.lower.y && inner.upper.x <= outer.upper.x &&
           inner.upper.y <= outer.upper.y;
}

// In the unit of the box (m); not meaningful for the empty box.
constexpr float perimeter(const Aabb& box) {
    return 2.0f * ((box.upper.x - box.lower.x) + (box.upper.y - box.lower.y));
}

}  // namespace tumble
