// The number that a text is.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace tumble::tools {

// Nothing if the text, or a part of it, is no number.
inline std::optional<double> number_of(std::string_view text) {
    double number = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

}  // namespace tumble::tools
