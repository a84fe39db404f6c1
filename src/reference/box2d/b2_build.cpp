#include "reference/box2d/b2_build.hpp"

#include <box2d/box2d.h>

namespace tumble::reference {

std::string box2d_version() {
    return std::to_string(b2_version.major) + "." + std::to_string(b2_version.minor) + "." +
           std::to_string(b2_version.revision);
}

std::string box2d_build() { return TUMBLE_BOX2D_BUILD; }

}  // namespace tumble::reference
