// How many pairs a property test tries, and of which families.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace tumble_test {

// As many as usual, or the number in the environment variable TUMBLE_PAIRS.
inline std::uint64_t pair_count(std::uint64_t usual = 10000) {
    const char* value = std::getenv("TUMBLE_PAIRS");
    return value ? std::strtoull(value, nullptr, 10) : usual;
}

// Every family, or the one that the environment names in TUMBLE_FAMILY.
inline bool is_family_selected(std::string_view name) {
    const char* value = std::getenv("TUMBLE_FAMILY");
    return !value || name == value;
}

// What is claimed of all families together need not hold for one.
inline bool is_every_family_selected() { return !std::getenv("TUMBLE_FAMILY"); }

}  // namespace tumble_test
