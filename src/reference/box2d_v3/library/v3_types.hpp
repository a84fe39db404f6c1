// The plain data of v3_library.hpp as types of Box2D v3.
#pragma once

#include <box2d/box2d.h>

#include <array>
#include <cstddef>

#include "reference/box2d_v3/library/v3_library.hpp"

namespace tumble::box2d_v3 {

inline std::array<b2Vec2, kMostPoints> vertices_of(const Points& points) {
    std::array<b2Vec2, kMostPoints> at{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(points.count); ++i)
        at[i] = {points.xy[2 * i], points.xy[2 * i + 1]};
    return at;
}

inline b2ShapeProxy proxy_of(const Points& points) {
    return b2MakeProxy(vertices_of(points).data(), points.count, points.radius);
}

inline b2Circle circle_of(const Points& points) { return {{points.xy[0], points.xy[1]}, points.radius}; }

// Of at least three points that are not on a line.
inline b2Polygon polygon_of(const Points& points) {
    const b2Hull hull = b2ComputeHull(vertices_of(points).data(), points.count);
    return b2MakePolygon(&hull, points.radius);
}

inline b2Transform transform_of(const Place& place) { return {{place.x, place.y}, {place.c, place.s}}; }

inline b2Sweep sweep_of(const Motion& motion) {
    return {{motion.center_x, motion.center_y},
            {motion.from.x, motion.from.y},
            {motion.to.x, motion.to.y},
            {motion.from.c, motion.from.s},
            {motion.to.c, motion.to.s}};
}

}  // namespace tumble::box2d_v3
