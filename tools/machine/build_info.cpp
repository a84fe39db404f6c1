#include "tools/machine/build_info.hpp"

namespace tumble::tools {

std::string version() { return TUMBLE_VERSION; }

std::string compiler_name() {
#ifdef __clang__
    return std::string("clang ") + __clang_version__;
#else
    return std::string("g++ ") + __VERSION__;
#endif
}

std::string build_type() { return TUMBLE_BUILD_TYPE; }

std::string compiler_flags() { return TUMBLE_FLAGS; }

}  // namespace tumble::tools
