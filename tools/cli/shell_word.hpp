// A text as one word of a shell command, for commands that a user or a script runs.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace tumble::tools {

// In single quotes, unless it has letters, digits and signs of paths alone.
inline std::string shell_word(const std::string& text) {
    const auto is_plain = [](unsigned char c) {
        return std::isalnum(c) != 0 || std::string("_-./=,:+").find(static_cast<char>(c)) != std::string::npos;
    };
    if (!text.empty() && std::ranges::all_of(text, is_plain)) return text;
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

}  // namespace tumble::tools
