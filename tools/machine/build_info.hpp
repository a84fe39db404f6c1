// How this binary was built.
#pragma once

#include <string>

namespace tumble::tools {

// "0.2.0"
std::string version();

// "g++ 12.2.0"
std::string compiler_name();

// "Release"
std::string build_type();

// "-O3 -DNDEBUG": what the user and the build type state. The simulation has -ffp-contract=off too.
std::string compiler_flags();

}  // namespace tumble::tools
