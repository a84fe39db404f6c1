// How a camera maps the world to the pixels of a frame.
//
// Pixel coordinates start in the middle of the frame, y up. The offset from the camera is computed in double and only
// the result becomes float, so that a scene 10 km from the origin is as sharp as one at it.
#pragma once

#include <algorithm>
#include <cmath>

#include "tumble/math.hpp"
#include "tumble/render.hpp"

namespace tumble::render {

struct View {
    DVec2 center;        // world point in the middle of the frame
    double scale = 1.0;  // pixels per metre
    int width = 0;
    int height = 0;

    DVec2 to_pixels(DVec2 world) const { return scale * (world - center); }
    DVec2 to_world(DVec2 pixels) const { return center + (1.0 / scale) * pixels; }

    // True if a disc may overlap the frame; centre and radius in pixels.
    bool is_in_view(DVec2 pixel, double radius) const {
        return std::abs(pixel.x) <= 0.5 * width + radius && std::abs(pixel.y) <= 0.5 * height + radius;
    }

    // The factor on line widths and text sizes, 1 at 720 rows: frames of any size look alike.
    double detail() const { return std::clamp(height / 720.0, 0.5, 6.0); }
};

inline View make_view(const Camera& camera, int width, int height) {
    return {camera.center, height / camera.height, width, height};
}

}  // namespace tumble::render
