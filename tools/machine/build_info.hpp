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

}  // namespace tumble::tools
