#include "tools/measure/version.hpp"

namespace tumble::tools {

std::string version() { return TUMBLE_VERSION; }

std::string compiler_name() {
#ifdef __clang__
    return std::string("clang ") + __clang_version__;
#else
    return std::string("g++ ") + __VERSION__;
#endif
}

}  // namespace tumble::tools
