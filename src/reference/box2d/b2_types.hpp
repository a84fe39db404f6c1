// Conversions to Box2D's types, and the lock around its queries.
#pragma once

#include <box2d/b2_math.h>

#include <mutex>

#include "tumble/cast.hpp"
#include "tumble/math.hpp"

namespace tumble::reference {

inline b2Vec2 to_b2(DVec2 v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }
inline b2Vec2 to_b2(Vec2 v) { return {v.x, v.y}; }

inline b2Transform to_b2(const Pose& pose) {
    b2Transform transform;
    transform.p = to_b2(pose.position);
    transform.q.c = pose.rotation.c;
    transform.q.s = pose.rotation.s;
    return transform;
}

inline b2Sweep to_b2(const Sweep& sweep) {
    b2Sweep result;
    result.localCenter = to_b2(sweep.local_center);
    result.c0 = to_b2(sweep.start);
    result.c = to_b2(sweep.end);
    result.a0 = static_cast<float>(sweep.start_angle);
    result.a = static_cast<float>(sweep.start_angle + sweep.turn);
    result.alpha0 = 0.0f;
    return result;
}

// Lock it around distance and time of impact queries: both count their calls in the same plain globals.
inline std::mutex b2_query_lock;

}  // namespace tumble::reference
