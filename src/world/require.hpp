// require(): throws std::invalid_argument that names an argument, what was expected and the value that was passed.
#pragma once

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

#include "tumble/math.hpp"

namespace tumble {

// Shortest decimal that reads back as the same number.
inline std::string print(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

inline std::string print(float value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

inline std::string print(Vec2 v) { return "(" + print(v.x) + ", " + print(v.y) + ")"; }
inline std::string print(DVec2 v) { return "(" + print(v.x) + ", " + print(v.y) + ")"; }

template <class Value>
void require(bool holds, const char* what, const char* expected, Value value) {
    if (!holds) throw std::invalid_argument(std::string(what) + " must be " + expected + ", got " + print(value));
}

inline void require_not_negative(float value, const char* what) {
    require(std::isfinite(value) && value >= 0.0f, what, "finite and not negative", value);
}

inline void require_finite(float value, const char* what) { require(std::isfinite(value), what, "finite", value); }

inline void require_positive(float value, const char* what) {
    require(std::isfinite(value) && value > 0.0f, what, "finite and greater than 0", value);
}

}  // namespace tumble
