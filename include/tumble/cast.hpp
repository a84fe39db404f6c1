// Moving shapes: ray cast, shape cast, swept overlap and time of impact, for every pair of shapes.
//
// A translation is solved in closed form on the Minkowski difference, a rotation by certified steps that never go
// beyond the first contact. Everything is computed in double, relative to A, and no tolerance is absolute: each answer
// comes with a bracket derived from the error bound E of its arithmetic, a few ulp of the sizes and offsets involved.
// Motions that stay within a few E of the target distance without going clearly below it (grazing) may be answered
// either way.
//
// Sources: Cyrus, Beck 1978 (clipping a line by convex faces); Mirtich 1996 (conservative advancement); Ericson,
// Real-Time Collision Detection, 2004, 5.5 (moving shapes as one ray against a difference).
#pragma once

#include <cstdint>

#include "tumble/distance.hpp"
#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble {

enum class CastStatus : std::uint8_t {
    hit,          // the target distance is reached; at fraction 0 if the motion starts there and approaches
    miss,         // it is not, or the motion starts there and recedes, slides along or stands still
    overlapping,  // the motion starts clearly below the target distance; fraction 0, and no point and normal
    invalid,      // NaN, infinity or overflow in the input, a shape without vertices, a negative radius or target;
                  // fraction, bounds, point and normal are NaN
};

struct CastResult {
    CastStatus status = CastStatus::invalid;
    double fraction = 0.0;  // of the motion, in [0, 1], when the target distance is reached; 1 for a miss
    double lower = 0.0;     // for a hit: the exact first fraction lies in [lower, upper]; lower may be below 0 and
    double upper = 0.0;     // upper above 1 by the error bound; 1 and 1 for a miss
    DVec2 point;   // for a hit: on the surface of A, or of the shape that a ray hits, at that fraction; world, m
    DVec2 normal;  // for a hit: unit, from A to B, or out of the shape that a ray hits
    std::int32_t iterations = 0;  // faces and corners evaluated, or certified steps taken
    bool reached_cap = false;     // time of impact only: ended by the bound on the steps. The result is a `hit` at the
                                  // last fraction that is proved free, with upper = 1
};

// The first point of a ray on a shape. The ray is the segment from `origin` to `origin + translation` (world, m). Only
// an entry from outside is a hit: a ray that starts inside is `overlapping`. No allocation; O(n).
CastResult cast_ray(const Shape& shape, const Pose& world_from_shape, DVec2 origin, DVec2 translation) noexcept;

// The first fraction at which B, moving by `translation` relative to A (world, m) without turning, is at the signed
// distance `target` >= 0 from A. No allocation; O(n + m).
CastResult cast_shape(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                      DVec2 translation, double target = 0.0) noexcept;

// Whether B touches A anywhere on its path by `translation` relative to A: GJK on the difference swept along the path.
// Cheaper than a cast for large polygons, but without a fraction: `touching` if the sign is below what double
// arithmetic can decide, 2^-49 of the sum of sizes, offset and path. No allocation.
DistanceStatus swept_overlap(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                             DVec2 translation) noexcept;

// A motion from fraction 0 to 1 of a time step: the centre of mass moves along a straight line, the shape turns about
// it at a constant rate.
struct Sweep {
    Vec2 local_center;         // centre of mass in the shape's coordinates
    DVec2 start;               // its world position at fraction 0
    DVec2 end;                 // and at fraction 1
    double start_angle = 0.0;  // radians
    double turn = 0.0;  // radians from fraction 0 to 1, counter-clockwise positive; may be more than a whole turn

    friend constexpr bool operator==(const Sweep&, const Sweep&) = default;
};

// The pose of the shape at a fraction; its rotation is rounded to float, and NaN for angles beyond 1e6 radians.
Pose pose_at(const Sweep& sweep, double fraction);

// The first fraction at which two moving shapes are at the signed distance `target` >= 0 (m). Never later than the
// first fraction at which the exact distance is below target - 4E. `invalid` if |start_angle| + |turn| of a sweep is
// more than 1e6 radians. At most kMaxImpactSteps steps; no allocation.
CastResult time_of_impact(const Shape& a, const Sweep& sweep_a, const Shape& b, const Sweep& sweep_b,
                          double target = 0.0) noexcept;

inline constexpr int kMaxImpactSteps = 256;

}  // namespace tumble
