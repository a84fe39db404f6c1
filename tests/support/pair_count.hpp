// How many pairs a property is tried on, and of which families.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace tumble_test {

// As many as usual, or the number in the environment variable TUMBLE_PAIRS.
inline std::uint64_t pair_count(std::uint64_t usual = 10000) {
    const char* asked = std::getenv("TUMBLE_PAIRS");
    return asked ? std::strtoull(asked, nullptr, 10) : usual;
}

// Every family, or the one that the environment names in TUMBLE_FAMILY.
inline bool is_family_asked_for(std::string_view name) {
    const char* asked = std::getenv("TUMBLE_FAMILY");
    return !asked || name == asked;
}

}  // namespace tumble_test
