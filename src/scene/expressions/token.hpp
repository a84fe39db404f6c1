// The words, numbers and signs of an expression.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::scene {

struct Token {
    enum class Kind { number, name, sign, end };
    Kind kind = Kind::end;
    std::size_t begin = 0, end = 0;  // bytes of the text
    std::string text{};              // of a name without its quotes; of a sign
    double number = 0.0;
    bool is_quoted = false;

    // A sign, or a word that is not in quotes.
    bool is(std::string_view word) const {
        return text == word && ((kind == Kind::name && !is_quoted) || kind == Kind::sign);
    }
};

// The tokens, the last of which is the end. Throws ExpressionError.
std::vector<Token> read_tokens(std::string_view text);

// Whether an expression can contain the name without quotes: letters, digits, _, bytes beyond ASCII, and [number] at
// the end.
bool is_plain_name(std::string_view name);

// 'car1/wheel', with two quotes for each in the name.
std::string quoted_name(std::string_view name);

// The name as an expression has it: in quotes if it needs them.
std::string in_expression(const std::string& name);

}  // namespace tumble::scene
