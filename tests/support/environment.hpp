// Numbers that a run of the tests takes from its environment.
#pragma once

#include <cstdlib>

namespace tumble::test {

// The integer in the environment variable, or `otherwise` if it is not set.
inline int from_environment(const char* name, int otherwise) {
    const char* const text = std::getenv(name);
    return text ? std::atoi(text) : otherwise;
}

}  // namespace tumble::test
