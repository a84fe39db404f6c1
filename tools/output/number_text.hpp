// Texts as numbers, and numbers as texts for pages.
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

namespace tumble::tools {

// Nothing if the text, or a part of it, is no number.
inline std::optional<double> number_of(std::string_view text) {
    double number = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

inline std::string four_digits(double number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", number);
    return text.data();
}

// "1 body", "3 bodies", "0 runs".
std::string counted(std::integral auto count, std::string_view noun) {
    std::string text = std::to_string(count) + " " + std::string(noun);
    if (count == 1) return text;
    return text.ends_with("body") ? text.substr(0, text.size() - 1) + "ies" : text + "s";
}

}  // namespace tumble::tools
