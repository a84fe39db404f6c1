// Prints JSON to be read by people: a value that fits on a line stays on it. Recursion is as deep as the value, which
// parse_json() bounds.
#include "scene/json/json_text.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace tumble::scene {

namespace {

constexpr std::size_t kLineWidth = 110;

constexpr std::size_t kLongestQuote = 40;  // bytes; a longer text is cut in messages

// Numbers in this range are written without an exponent.
constexpr double kLeastPlain = 1e-5;
constexpr double kMostPlain = 1e15;

std::string scalar_text(const Json& value) {
    if (value.is_number_float()) return number_text(value.get<double>());
    if (value.is_string()) return quoted(value.get_ref<const std::string&>());
    return value.dump();
}

// Appends the value on one line. False, with `out` unspecified, if that makes it longer than `limit`.
bool append_compact(const Json& value, std::size_t limit, std::string& out) {
    if (!value.is_structured()) {
        out += scalar_text(value);
        return out.size() <= limit;
    }
    out += value.is_object() ? '{' : '[';
    bool first = true;
    for (const auto& [key, element] : value.items()) {
        if (!first) out += ", ";
        first = false;
        if (value.is_object()) out += quoted(key) + ": ";
        if (!append_compact(element, limit, out)) return false;
    }
    out += value.is_object() ? '}' : ']';
    return out.size() <= limit;
}

// True for arrays of numbers and of vectors, whose elements share lines.
bool is_number_list(const Json& value, int depth = 2) {
    if (value.is_number()) return true;
    if (!value.is_array() || depth == 0) return false;
    for (const Json& element : value)
        if (!is_number_list(element, depth - 1)) return false;
    return true;
}

void append_pretty(const Json& value, std::size_t indent, std::size_t column, bool may_stay, std::string& out);

void append_filled(const Json& list, std::size_t indent, std::string& out) {
    std::size_t column = kLineWidth;
    std::string element_text;
    for (std::size_t i = 0; i < list.size(); ++i) {
        element_text.clear();
        append_compact(list[i], std::string::npos, element_text);
        if (i + 1 < list.size()) element_text += ',';
        if (column + 1 + element_text.size() > kLineWidth) {
            out += '\n' + std::string(indent, ' ') + element_text;
            column = indent + element_text.size();
        } else {
            out += ' ' + element_text;
            column += 1 + element_text.size();
        }
    }
}

void append_broken(const Json& value, std::size_t indent, std::string& out) {
    std::size_t left = value.size();
    for (const auto& [key, element] : value.items()) {
        const std::string label = value.is_object() ? quoted(key) + ": " : "";
        out += '\n' + std::string(indent, ' ') + label;
        append_pretty(element, indent, indent + label.size(), true, out);
        if (--left > 0) out += ',';
    }
}

void append_pretty(const Json& value, std::size_t indent, std::size_t column, bool may_stay, std::string& out) {
    const std::size_t room = column + 1 < kLineWidth ? kLineWidth - column - 1 : 0;
    std::string line;
    if (!value.is_structured() || value.empty() || (may_stay && append_compact(value, room, line))) {
        out += value.is_structured() && value.empty() ? (value.is_object() ? "{}" : "[]")
               : value.is_structured()                ? line
                                                      : scalar_text(value);
        return;
    }
    out += value.is_object() ? '{' : '[';
    if (value.is_array() && is_number_list(value)) {
        append_filled(value, indent + 2, out);
    } else {
        append_broken(value, indent + 2, out);
    }
    out += '\n' + std::string(indent, ' ') + (value.is_object() ? '}' : ']');
}

}  // namespace

std::string number_text(double value) {
    if (!std::isfinite(value)) throw std::invalid_argument("a number that is not finite cannot be written as JSON");
    char digits[32];
    const double number = value + 0.0;  // no -0
    const bool plain = number == 0.0 || (std::abs(number) >= kLeastPlain && std::abs(number) < kMostPlain);
    const std::chars_format format = plain ? std::chars_format::fixed : std::chars_format::scientific;
    const std::to_chars_result end = std::to_chars(digits, digits + sizeof digits, number, format);
    return {digits, end.ptr};
}

std::string quoted(const std::string& text) { return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string compact_text(const Json& value) {
    std::string out;
    append_compact(value, std::string::npos, out);
    return out;
}

std::string describe(const Json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return value.empty() ? "an empty array" : "an array of " + std::to_string(value.size());
    const std::string text = compact_text(value);
    return text.size() <= kLongestQuote ? text : quoted(value.get<std::string>().substr(0, kLongestQuote)) + "...";
}

std::string pretty_text(const Json& value) {
    std::string out;
    append_pretty(value, 0, 0, false, out);
    return out + '\n';
}

}  // namespace tumble::scene
