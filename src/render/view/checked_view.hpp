// Sizes and cameras of a caller, checked.
#pragma once

#include "render/view/view.hpp"

namespace tumble::render {

// The number of pixels. Throws std::invalid_argument, with the name of the side, unless it is kSmallestFrame to
// kLargestFrame.
int checked_side(const char* name, int pixels);

// Throws std::invalid_argument for a camera that is not finite or without height.
View checked_view(const Camera& camera, int width, int height);

}  // namespace tumble::render
