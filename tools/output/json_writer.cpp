#include "tools/output/json_writer.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tumble::tools {

namespace {

template <class Number>
void append_shortest(std::string& text, Number number) {
    if (std::isnan(number)) {  // its sign is another on another processor
        text += "nan";
        return;
    }
    char digits[32];  // the shortest double has at most 24 characters
    const std::to_chars_result end = std::to_chars(digits, digits + sizeof digits, number);
    text.append(digits, end.ptr);
}

bool needs_escape(char character) {
    const auto code = static_cast<unsigned char>(character);
    return code < 0x20 || code == 0x7f || character == '"' || character == '\\';
}

}  // namespace

void append_number(std::string& text, double number) { append_shortest(text, number); }
void append_number(std::string& text, float number) { append_shortest(text, number); }

std::string to_hex(std::uint64_t hash) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text(16, '0');
    for (std::size_t i = 16; i-- > 0; hash >>= 4) text[i] = kDigits[hash & 15];
    return text;
}

void JsonWriter::clear() {
    text_.clear();
    levels_.clear();
    after_key_ = false;
}

JsonWriter& JsonWriter::key(std::string_view name) {
    separate(true);
    append_string(name);
    text_ += layout_ == Layout::lines ? ": " : ":";
    after_key_ = true;
    return *this;
}

JsonWriter& JsonWriter::value(double number) {
    if (!std::isfinite(number)) return literal("null");
    separate(false);
    append_number(text_, number);
    return *this;
}

JsonWriter& JsonWriter::value(float number) {
    if (!std::isfinite(number)) return literal("null");
    separate(false);
    append_number(text_, number);
    return *this;
}

JsonWriter& JsonWriter::value(const std::vector<std::string>& strings) {
    open_array();
    for (const std::string& string : strings) value(string);
    return close_array();
}

JsonWriter& JsonWriter::value(std::string_view string) {
    separate(false);
    append_string(string);
    return *this;
}

JsonWriter& JsonWriter::literal(std::string_view text) {
    separate(false);
    text_ += text;
    return *this;
}

JsonWriter& JsonWriter::open(char bracket) {
    separate(bracket == '{');
    text_ += bracket;
    levels_.push_back({});
    return *this;
}

JsonWriter& JsonWriter::close(char bracket) {
    const Level level = levels_.back();
    levels_.pop_back();
    if (level.has_lines) start_line(levels_.size());
    text_ += bracket;
    return *this;
}

// Writes the comma before the next element of the innermost container, and in the layout `lines` a line break before
// keys and before objects in arrays.
void JsonWriter::separate(bool on_new_line) {
    if (after_key_) {
        after_key_ = false;
        return;
    }
    if (levels_.empty()) return;
    Level& level = levels_.back();
    if (!level.empty) text_ += ',';
    if (layout_ == Layout::lines && on_new_line) {
        level.has_lines = true;
        start_line(levels_.size());
    } else if (layout_ == Layout::lines && !level.empty) {
        text_ += ' ';
    }
    level.empty = false;
}

void JsonWriter::start_line(std::size_t depth) {
    text_ += '\n';
    text_.append(2 * depth, ' ');
}

void JsonWriter::append_string(std::string_view string) {
    constexpr char kDigits[] = "0123456789abcdef";
    text_ += '"';
    if (std::ranges::none_of(string, needs_escape)) {  // the common case
        text_ += string;
        text_ += '"';
        return;
    }
    for (const char character : string) {
        const auto code = static_cast<unsigned char>(character);
        if (character == '"' || character == '\\') {
            text_ += '\\';
            text_ += character;
        } else if (character == '\n') {
            text_ += "\\n";
        } else if (needs_escape(character)) {
            text_ += "\\u00";
            text_ += kDigits[code >> 4];
            text_ += kDigits[code & 15];
        } else {
            text_ += character;
        }
    }
    text_ += '"';
}

}  // namespace tumble::tools
