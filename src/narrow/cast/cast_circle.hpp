// The point at which a path enters a circle, with a bracket by the path's error bound.
#pragma once

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
#include "narrow/cast/cast_clip.hpp"

namespace tumble {

// Distances along the path.
struct CircleEntry {
    bool is_reached = false;  // within E
    bool is_certain = false;
    double entry = 0.0;
    double lower = 0.0;
    double upper = 0.0;
    DVec2 from_center;  // to where the path enters; zero for a radius of 0
};

// How far along a path a circle around a point `ahead` on and `aside` off is entered.
inline double enter_circle(double ahead, double aside, double radius) {
    return ahead - std::sqrt(std::max(0.0, (radius - aside) * (radius + aside)));
}

// The entry into the circle of radius `reach` around the point, from outside.
inline CircleEntry find_circle_entry(const CastPath& path, DVec2 center) {
    TUMBLE_CHECK(path.length > 0.0);
    const DVec2 heading = (1.0 / path.length) * path.motion;
    const double ahead = dot(heading, center), offside = cross(heading, center), aside = std::abs(offside);
    if (!(ahead > 0.0 && aside <= path.reach + path.error)) return {};
    const double entry = enter_circle(ahead, aside, path.reach), error = 2.0 * path.error;
    return {entry >= 0.0,
            aside <= path.reach - path.error,
            entry,
            enter_circle(ahead, aside, path.reach + error) - path.error,
            enter_circle(ahead, aside, std::max(0.0, path.reach - error)) + path.error,
            (entry - ahead) * heading - offside * perp(heading)};
}

}  // namespace tumble
