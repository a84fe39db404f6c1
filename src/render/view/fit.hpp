// The part of the world that a camera shows when the scene does not state it.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "render/view/motion_preview.hpp"

namespace tumble::render {

inline constexpr double kMargin = 1.14;            // factor on a fitted height
inline constexpr double kHeightPerFollowed = 5.0;  // least height of a frame that follows a body, over its larger side

// A box around all bodies that are not static and the ground below them. Static shapes are included whole if the frame
// becomes at most 1.75 times as high by that, else only near the moving bodies. The motions are included too, except of
// bodies that leave a frame three times as high as one fitted to the start and the room around them: a body that falls
// off the level does not shrink the rest. A room is a static body, not of sensors alone, whose box contains the whole
// motion and is at most 24 times as large as the box around all moving bodies. Empty for a world without shapes.
Box fitted_box(const World& world, const std::vector<MotionBounds>& motions, double aspect_ratio);

// The motion of the largest body of those that drive away: they leave a frame three times as high as one fitted to the
// start and the room around them, further sideways than up or down. None if fewer than half of the bodies do so, for a
// frame that moves with one of them would not show the rest.
std::optional<MotionBounds> leading_motion(const World& world, const std::vector<MotionBounds>& motions,
                                           double aspect_ratio);

// The height of a frame that contains a box of that size.
inline double height_for(DVec2 size, double aspect_ratio) { return std::max(size.y, size.x / aspect_ratio); }

}  // namespace tumble::render
