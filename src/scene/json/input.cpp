// One pass of the parser: its events build the value, and detect duplicate keys, which the builder would drop, and deep
// nesting, on which later recursion would overflow the stack.
#include "scene/json/input.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "scene/json/pointer.hpp"

namespace tumble::scene {

namespace {

class CheckedBuilder : public nlohmann::json_sax<Json> {
public:
    CheckedBuilder(std::string_view text, Json& value, Diagnostics& diagnostics)
        : text_(text), diagnostics_(diagnostics), builder_(value) {}

    bool null() override { return element() && builder_.null(); }
    bool boolean(bool truth) override { return element() && builder_.boolean(truth); }
    bool number_integer(number_integer_t number) override { return element() && builder_.number_integer(number); }
    bool number_unsigned(number_unsigned_t number) override { return element() && builder_.number_unsigned(number); }
    bool number_float(number_float_t number, const string_t& digits) override {
        return element() && builder_.number_float(number, digits);
    }
    bool string(string_t& text) override { return element() && builder_.string(text); }
    bool binary(binary_t& bytes) override { return element() && builder_.binary(bytes); }
    bool start_object(std::size_t size) override { return open(true) && builder_.start_object(size); }
    bool start_array(std::size_t size) override { return open(false) && builder_.start_array(size); }
    bool end_object() override { return close() && builder_.end_object(); }
    bool end_array() override { return close() && builder_.end_array(); }

    bool key(string_t& name) override {
        Level& level = levels_.back();
        if (!level.keys.insert(name).second)
            diagnostics_.error(append_key(pointer(), name), "this key occurs twice", "", Diagnostics::At::key);
        level.key = name;
        if (level.keys.size() <= kMaxKeysInObject) return builder_.key(name);
        diagnostics_.error(pointer(), "the object has more than " + std::to_string(kMaxKeysInObject) + " keys");
        return false;
    }

    bool parse_error(std::size_t position, const std::string& last_token,
                     const nlohmann::detail::exception& cause) override {
        // The position counts bytes read, the offending one included.
        std::size_t offset = std::min(position > 0 ? position - 1 : 0, text_.size());
        if (cause.id == kNumberOverflow) {
            offset = position > last_token.size() ? position - last_token.size() : 0;
            diagnostics_.error_at_offset(offset, "the number is too large for a double, got " + last_token);
            return false;
        }
        const std::string why = reason(cause.what());
        diagnostics_.error_at_offset(offset, why, hint(offset, why, last_token));
        return false;
    }

private:
    static constexpr int kNumberOverflow = 406;

    struct Level {
        bool is_object = false;
        std::size_t next_index = 0;  // of the elements of an array
        std::string key;             // the last of an object
        std::set<std::string> keys;
    };

    bool element() {
        if (!levels_.empty()) ++levels_.back().next_index;
        return true;
    }

    bool open(bool is_object) {
        if (levels_.size() == kMaxDepth) {
            diagnostics_.error(pointer(), "the file is nested deeper than " + std::to_string(kMaxDepth) + " levels");
            return false;
        }
        levels_.push_back({is_object, 0, "", {}});
        return true;
    }

    bool close() {
        levels_.pop_back();
        return element();
    }

    // The pointer to the innermost open container.
    std::string pointer() const {
        std::string result;
        for (std::size_t i = 0; i + 1 < levels_.size(); ++i) {
            const Level& level = levels_[i];
            result = append_key(result, level.is_object ? level.key : std::to_string(level.next_index));
        }
        return result;
    }

    // The parser's message is "[json.exception...] parse error at line l, column c: syntax error while parsing X -
    // what; last read: '...'". Line and column are left out because Diagnostics adds them, and the last read token
    // because it may contain any bytes.
    static std::string reason(const std::string& what) {
        const std::size_t start = what.find("syntax error");
        std::string text = start == std::string::npos ? what : what.substr(start);
        const std::size_t read = text.find("; last read: ");
        const std::size_t expected = text.rfind("; expected ");
        if (read == std::string::npos) return text;
        return text.substr(0, read) + (expected != std::string::npos && expected > read ? text.substr(expected) : "");
    }

    static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

    // After a colon it begins a colour without quotes.
    std::string hint_for_number_sign(std::size_t offset) const {
        const std::size_t before = text_.substr(0, offset).find_last_not_of(" \t\r\n");
        const bool is_value = before != std::string_view::npos && text_[before] == ':';
        return is_value ? R"(a colour takes double quotes: "#d33")" : "a comment begins with //";
    }

    // Whether the text before the token, which ends at an offset, is a zero: 010 is read as 0 and 10.
    bool follows_zero(std::size_t offset, const std::string& token) const {
        if (offset >= text_.size() || token.empty()) return false;  // at the end of the text there is no token
        return token.size() <= offset && text_[offset - token.size()] == '0' && token[0] >= '0' && token[0] <= '9';
    }

    // The offset is that of the last byte of the token.
    std::string hint(std::size_t offset, const std::string& why, const std::string& token) const {
        const bool wants_end = why.ends_with("expected '}'") || why.ends_with("expected ']'");
        const bool begins_value = why.find("literal; expected") != std::string::npos ||
                                  why.find("unexpected '{'") != std::string::npos ||
                                  why.find("unexpected '['") != std::string::npos;
        const char c = offset < text_.size() ? text_[offset] : '\0';
        if (offset > 0 && text_[offset - 1] == '0' && (c == 'x' || c == 'b')) return "numbers are written in decimal";
        if (c == '#') return hint_for_number_sign(offset);
        if (c == '<' && levels_.empty()) return "a drawing (SVG) becomes a scene by `tumble import`";
        if (follows_zero(offset, token)) return "a number has no zeros before it: " + token;
        if (wants_end && begins_value) return "a comma is missing before it";
        if (text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff")) return "save the file as UTF-8, not UTF-16";
        if (why.find("UTF-8") != std::string::npos) return "save the file as UTF-8";
        if (why.find("unexpected end") != std::string::npos && !levels_.empty())
            return std::string("the last '") + (levels_.back().is_object ? "{" : "[") + "' is not closed";
        if (c == '\'') return "strings and keys take double quotes";
        const bool follows_letter = c == ':' && offset > 0 && is_letter(text_[offset - 1]);
        if (why.find("expected string literal") != std::string::npos && (is_letter(c) || follows_letter))
            return "keys take double quotes";
        if (c == 'I' || (c == 'N' && text_.substr(offset).starts_with("NaN"))) return "JSON has no NaN and no Infinity";
        if (c == '+') return "a number has no + before it";
        if (c == '.') return "a number begins with a digit: 0.5";
        if ((c == '}' || c == ']') && text_.substr(0, offset).find_last_not_of(" \t\r\n") != std::string_view::npos &&
            text_[text_.substr(0, offset).find_last_not_of(" \t\r\n")] == ',')
            return "remove the comma before it";
        return {};
    }

    std::string_view text_;
    Diagnostics& diagnostics_;
    nlohmann::detail::json_sax_dom_parser<Json> builder_;
    std::vector<Level> levels_;
};

}  // namespace

std::string_view without_byte_order_mark(std::string_view text) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

std::optional<Json> parse_json(std::string_view text, Diagnostics& diagnostics, const std::string& if_empty) {
    if (text.size() > kMaxFileBytes) {
        diagnostics.error_at_offset(0, "the file is longer than " + std::to_string(kMaxFileBytes >> 20) + " MiB");
        return std::nullopt;
    }
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
        diagnostics.error_at_offset(0, "the file is empty", if_empty);
        return std::nullopt;
    }
    Json value;
    CheckedBuilder builder(text, value, diagnostics);
    if (!Json::sax_parse(text, &builder, Json::input_format_t::json, true, true)) return std::nullopt;
    return value;
}

}  // namespace tumble::scene
