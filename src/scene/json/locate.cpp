// The parser keeps no positions, so a second pass over the text finds them. The text is valid JSON with comments, so
// the tokenizer only has to skip.
#include "scene/json/locate.hpp"

#include <algorithm>
#include <charconv>
#include <string>

#include "scene/json/json.hpp"
#include "scene/json/pointer.hpp"

namespace tumble::scene {

namespace {

class Tokenizer {
public:
    explicit Tokenizer(std::string_view text) : text_(text) { skip_blank(); }

    std::size_t position() const { return position_; }
    bool at(char c) const { return position_ < text_.size() && text_[position_] == c; }

    // Skips a punctuation character, if it is next, and the blanks after it.
    bool accept(char c) {
        if (!at(c)) return false;
        ++position_;
        skip_blank();
        return true;
    }

    // Skips the value at the position and returns its text.
    std::string_view take_value() {
        const std::size_t start = position_;
        int depth = 0;
        do {
            if (at('"')) {
                skip_string();
            } else if (at('{') || at('[')) {
                ++depth;
                ++position_;
            } else if (at('}') || at(']')) {
                --depth;
                ++position_;
            } else if (at(',') || at(':')) {
                ++position_;
            } else {
                skip_word();
            }
            end_ = position_;
            skip_blank();
        } while (depth > 0 && position_ < text_.size());
        return text_.substr(start, end_ - start);
    }

private:
    static constexpr std::string_view kEndOfWord = " \t\r\n,:[]{}\"/";

    void skip_blank() {
        while (position_ < text_.size()) {
            if (text_.substr(position_, 2) == "//") {
                position_ = std::min(text_.find('\n', position_), text_.size());
            } else if (text_.substr(position_, 2) == "/*") {
                const std::size_t close = text_.find("*/", position_ + 2);
                position_ = close == std::string_view::npos ? text_.size() : close + 2;
            } else if (std::string_view(" \t\r\n").find(text_[position_]) != std::string_view::npos) {
                ++position_;
            } else {
                return;
            }
        }
    }

    void skip_string() {
        for (++position_; position_ < text_.size() && !at('"'); ++position_)
            if (at('\\')) ++position_;
        position_ = std::min(position_ + 1, text_.size());
    }

    void skip_word() { position_ = std::min(text_.find_first_of(kEndOfWord, position_ + 1), text_.size()); }

    std::string_view text_;
    std::size_t position_ = 0;
    std::size_t end_ = 0;
};

struct Found {
    std::size_t value = std::string_view::npos;
    std::size_t key = 0;
};

Found find_member(Tokenizer tokens, const std::string& name) {
    Found found;
    tokens.accept('{');
    while (tokens.at('"')) {
        const std::size_t key_position = tokens.position();
        const Json key = Json::parse(tokens.take_value(), nullptr, false);
        tokens.accept(':');
        if (key.is_string() && key.get_ref<const std::string&>() == name) found = {tokens.position(), key_position};
        tokens.take_value();
        if (!tokens.accept(',')) break;
    }
    return found;
}

Found find_element(Tokenizer tokens, const std::string& name) {
    tokens.accept('[');
    for (std::size_t index = 0; !tokens.at(']'); ++index) {
        if (std::to_string(index) == name) return {tokens.position(), tokens.position()};
        tokens.take_value();
        if (!tokens.accept(',')) break;
    }
    return {};
}

// How many bytes of UTF-8 a code of four hexadecimal digits stands for; 2 for half of a surrogate pair.
std::size_t utf8_size(std::string_view digits) {
    unsigned code = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    const bool is_half_of_pair = code >= 0xD800u && code < 0xE000u;
    return code < 0x80u ? 1 : code < 0x800u || is_half_of_pair ? 2 : 3;
}

}  // namespace

std::size_t find_offset(std::string_view text, std::string_view pointer, bool at_key) {
    Tokenizer tokens(text);
    std::size_t offset = tokens.position();
    std::size_t key_offset = offset;
    for (const std::string& step : split_pointer(pointer)) {
        const Tokenizer here(text.substr(offset));
        const Found found = here.at('{') ? find_member(here, step) : here.at('[') ? find_element(here, step) : Found{};
        if (found.value == std::string_view::npos) return offset;
        key_offset = offset + found.key;
        offset += found.value;
    }
    return at_key ? key_offset : offset;
}

std::size_t offset_in_string(std::string_view text, std::size_t string, std::size_t inside) {
    if (string >= text.size() || text[string] != '"') return string;
    std::size_t at = string + 1;
    while (inside > 0 && at < text.size() && text[at] != '"') {
        const bool is_escape = text[at] == '\\', is_code = is_escape && text.substr(at + 1, 1) == "u";
        const std::size_t bytes = is_code ? utf8_size(text.substr(std::min(at + 2, text.size()), 4)) : 1;
        at = std::min(text.size(), at + (is_code ? 6 : is_escape ? 2 : 1));
        inside -= std::min(inside, bytes);
    }
    return at;
}

}  // namespace tumble::scene
