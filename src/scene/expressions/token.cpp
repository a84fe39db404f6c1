#include "scene/expressions/token.hpp"

#include <algorithm>
#include <charconv>

#include "scene/model/names.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::scene {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<unsigned char>(c) >= 0x80u;
}

class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {}

    std::vector<Token> scan() {
        std::vector<Token> tokens;
        do {
            while (is_one_of(" \t\r\n")) ++at_;
            tokens.push_back(next());
        } while (tokens.back().kind != Token::Kind::end);
        return tokens;
    }

private:
    bool is_one_of(std::string_view set) const { return at_ < text_.size() && set.find(text_[at_]) != set.npos; }
    bool is_digit_at(std::size_t place) const { return place < text_.size() && is_digit(text_[place]); }

    Token next() {
        const std::size_t begin = at_;
        Token token;
        if (at_ == text_.size()) return {.begin = begin, .end = begin};
        const char c = text_[at_];
        if (is_digit(c) || (c == '.' && is_digit_at(at_ + 1)))
            token = number();
        else if (is_letter(c))
            token = word();
        else if (c == '\'')
            token = quoted();
        else
            token = sign();
        token.begin = begin;
        token.end = at_;
        return token;
    }

    Token number() {
        Token token{.kind = Token::Kind::number};
        const std::from_chars_result read =
            std::from_chars(text_.data() + at_, text_.data() + text_.size(), token.number);
        if (read.ec != std::errc{}) throw ExpressionError(at_, "the number is outside the range of a double");
        at_ = static_cast<std::size_t>(read.ptr - text_.data());
        return token;
    }

    Token word() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
        Token token{.kind = Token::Kind::name};
        token.text = std::string(text_.substr(begin, at_ - begin));
        token.text += index();
        return token;
    }

    Token quoted() {
        const std::size_t begin = at_++;
        Token token{.kind = Token::Kind::name, .is_quoted = true};
        for (; at_ < text_.size(); ++at_) {
            if (text_[at_] == '\'') {
                ++at_;
                if (!is_one_of("'")) {
                    token.text += index();
                    return token;
                }
            }
            token.text += text_[at_];
        }
        throw ExpressionError(begin, "the quote ' is not closed", "a name in quotes is written 'my name'");
    }

    // "[3]" of a copy, or nothing.
    std::string index() {
        if (!is_one_of("[")) return {};
        const std::size_t begin = at_++;
        while (is_digit_at(at_)) ++at_;
        if (at_ == begin + 1 || !is_one_of("]"))
            throw ExpressionError(begin, "'[' must be followed by the number of a copy and ']'",
                                  "for example crate[3]");
        ++at_;
        return std::string(text_.substr(begin, at_ - begin));
    }

    Token sign() {
        for (const std::string_view sign : {"<=", ">=", "==", "!=", "&&", "||", "**"})
            if (text_.substr(at_).starts_with(sign)) return take(sign);
        constexpr std::string_view kSigns = "+-*/^()<>,.=!&|";
        const std::size_t found = kSigns.find(text_[at_]);
        if (found != kSigns.npos) return take(kSigns.substr(found, 1));
        if (text_[at_] == '"') throw ExpressionError(at_, "unexpected \"", "names are quoted by ', as in 'my name'.x");
        const bool is_visible = text_[at_] > ' ' && text_[at_] < '\x7f';
        throw ExpressionError(at_,
                              is_visible ? std::string("unexpected ") + text_[at_] : "unexpected control character");
    }

    Token take(std::string_view sign) {
        at_ += sign.size();
        return {.kind = Token::Kind::sign, .text = std::string(sign)};
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

std::vector<Token> read_tokens(std::string_view text) { return Scanner(text).scan(); }

bool is_plain_name(std::string_view name) {
    const std::string_view base = copy_number(name) ? base_name(name) : name;
    return !base.empty() && !is_digit(base[0]) &&
           std::ranges::all_of(base, [](char c) { return is_letter(c) || is_digit(c); });
}

std::string quoted_name(std::string_view name) {
    std::string text = "'";
    for (const char c : name) text += c == '\'' ? std::string("''") : std::string(1, c);
    return text + "'";
}

std::string in_expression(const std::string& name) { return is_plain_name(name) ? name : quoted_name(name); }

}  // namespace tumble::scene
