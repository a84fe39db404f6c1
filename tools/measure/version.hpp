// What this binary is.
#pragma once

#include <string>

namespace tumble::tools {

// "0.1.0"
std::string version();

// "g++ 12.2.0"
std::string compiler_name();

}  // namespace tumble::tools
