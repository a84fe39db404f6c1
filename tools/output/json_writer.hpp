// Writes JSON text.
//
// Numbers are the shortest decimal that reads back as the same value. NaN and infinities become null, because JSON
// cannot represent them.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/math.hpp"

namespace tumble::tools {

// Appends the shortest decimal that reads back as the same value ("0.1", "1e-07", "-0", "nan", "inf").
void append_number(std::string& text, double number);
void append_number(std::string& text, float number);

// 16 hexadecimal digits, the form of 64-bit hashes in all output.
std::string to_hex(std::uint64_t hash);

class JsonWriter {
public:
    // `lines` puts each member on its own line, and an array of plain values on one; `compact` is for JSON lines.
    enum class Layout { lines, compact };
    explicit JsonWriter(Layout layout = Layout::lines) : layout_(layout) {}

    JsonWriter& open_object() { return open('{'); }
    JsonWriter& close_object() { return close('}'); }
    JsonWriter& open_array() { return open('['); }
    JsonWriter& close_array() { return close(']'); }
    JsonWriter& key(std::string_view name);

    JsonWriter& value(double number);
    JsonWriter& value(float number);
    JsonWriter& value(bool truth) { return literal(truth ? "true" : "false"); }
    JsonWriter& value(std::integral auto number) { return literal(std::to_string(number)); }
    JsonWriter& value(DVec2 vector) { return open_array().value(vector.x).value(vector.y).close_array(); }
    JsonWriter& value(std::string_view string);
    JsonWriter& value(const char* string) { return value(std::string_view(string)); }
    JsonWriter& value(const std::string& string) { return value(std::string_view(string)); }
    JsonWriter& value(const std::vector<std::string>& strings);

    template <class Value>
    JsonWriter& member(std::string_view name, const Value& of) {
        return key(name).value(of);
    }

    // The text so far. clear() starts a new document and keeps the memory.
    const std::string& text() const noexcept { return text_; }
    void clear();

private:
    struct Level {
        bool empty = true;
        bool has_lines = false;
    };

    JsonWriter& open(char bracket);
    JsonWriter& close(char bracket);
    JsonWriter& literal(std::string_view text);
    void separate(bool on_new_line);
    void start_line(std::size_t depth);
    void append_string(std::string_view string);

    Layout layout_;
    bool after_key_ = false;
    std::string text_;
    std::vector<Level> levels_;
};

}  // namespace tumble::tools
