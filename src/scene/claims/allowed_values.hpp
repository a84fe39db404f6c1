// How far values are from those that claims allow.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/model/frame.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

// The excess of a claim on a body that does not exist.
inline constexpr double kAbsent = std::numeric_limits<double>::infinity();

inline double excess_of(double value, const SceneInterval& allowed) {
    if (std::isnan(value)) return kAbsent;
    return std::max({0.0, allowed.lower - value, value - allowed.upper});
}

inline bool contains(const SceneBox& box, DVec2 p) {
    return p.x >= box.first.x && p.x <= box.second.x && p.y >= box.first.y && p.y <= box.second.y;
}

// The frame in which a claim measures.
inline Pose frame_of(const SceneExpectation& claim) { return make_frame(claim.frame.value_or(SceneFrame{})); }

}  // namespace tumble::scene
