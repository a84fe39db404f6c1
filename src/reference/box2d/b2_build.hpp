// Which Box2D the comparisons run, and how it was compiled.
#pragma once

#include <string>

namespace tumble::reference {

// "2.4.1", as its CMake package states it: the number in the library 2.4.1 is that of 2.4.0.
std::string box2d_version();

// Its package and how that is compiled, as the configuration of the build found them: "Debian's libbox2d2 2.4.1-3:
// ...". The CMake variable TUMBLE_BOX2D_BUILD states it for a library that is of no package.
std::string box2d_build();

}  // namespace tumble::reference
