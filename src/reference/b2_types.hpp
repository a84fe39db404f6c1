// Our types as Box2D's.
#pragma once

#include <box2d/b2_math.h>

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

}  // namespace tumble::reference
