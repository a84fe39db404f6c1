#include "reference/box2d/b2_build.hpp"

namespace tumble::reference {

std::string box2d_version() { return TUMBLE_BOX2D_VERSION; }

std::string box2d_build() { return TUMBLE_BOX2D_BUILD; }

}  // namespace tumble::reference
