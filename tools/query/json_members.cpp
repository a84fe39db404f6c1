#include "tools/query/json_members.hpp"

#include <algorithm>

namespace tumble::tools {

namespace {

constexpr std::string_view kSpace = " \t\r\n";

void skip_space(std::string_view& text) { text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size())); }

bool take(std::string_view& text, char expected) {
    skip_space(text);
    if (text.empty() || text.front() != expected) return false;
    text.remove_prefix(1);
    return true;
}

// The length of a string at the start of the text, quotes included; 0 if there is none.
std::size_t string_length(std::string_view text) {
    if (text.empty() || text.front() != '"') return 0;
    for (std::size_t at = 1; at < text.size(); ++at) {
        if (text[at] == '\\')
            ++at;
        else if (text[at] == '"')
            return at + 1;
    }
    return 0;
}

// The length of a value at the start of the text: up to the comma or bracket that ends it outside of all brackets.
std::size_t value_length(std::string_view text) {
    std::size_t depth = 0, at = 0;
    while (at < text.size()) {
        const char c = text[at];
        if (depth == 0 && (c == ',' || c == '}' || c == ']')) return at;
        if (c == '"') {
            const std::size_t length = string_length(text.substr(at));
            if (length == 0) return 0;
            at += length;
            continue;
        }
        if (c == '{' || c == '[') ++depth;
        if (c == '}' || c == ']') --depth;
        ++at;
    }
    return 0;
}

}  // namespace

std::optional<std::vector<JsonMember>> split_members(std::string_view object) {
    std::vector<JsonMember> members;
    if (!take(object, '{')) return std::nullopt;
    if (!take(object, '}')) {
        do {
            skip_space(object);
            const std::size_t key_length = string_length(object);
            if (key_length == 0) return std::nullopt;
            const std::string_view key = object.substr(1, key_length - 2);
            object.remove_prefix(key_length);
            if (!take(object, ':')) return std::nullopt;
            skip_space(object);
            const std::size_t length = value_length(object);
            if (length == 0) return std::nullopt;
            members.push_back({key, object.substr(0, length)});
            object.remove_prefix(length);
        } while (take(object, ','));
        if (!take(object, '}')) return std::nullopt;
    }
    skip_space(object);
    if (!object.empty()) return std::nullopt;
    return members;
}

}  // namespace tumble::tools
