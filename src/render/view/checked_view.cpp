#include "render/view/checked_view.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace tumble::render {

int checked_side(const char* name, int pixels) {
    if (pixels < kSmallestFrame || pixels > kLargestFrame)
        throw std::invalid_argument(std::string("the ") + name + " of a frame must be " +
                                    std::to_string(kSmallestFrame) + " to " + std::to_string(kLargestFrame) +
                                    " pixels, got " + std::to_string(pixels));
    return pixels;
}

View checked_view(const Camera& camera, int width, int height) {
    if (!is_finite(camera.center) || !(camera.height > 0.0) || !std::isfinite(camera.height))
        throw std::invalid_argument("a camera needs a finite center and a height above 0, got (" +
                                    std::to_string(camera.center.x) + ", " + std::to_string(camera.center.y) +
                                    ") and " + std::to_string(camera.height));
    return make_view(camera, width, height);
}

}  // namespace tumble::render
