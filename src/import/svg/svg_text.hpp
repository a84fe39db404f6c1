// Numbers, lengths and words in the attributes of an SVG file.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace tumble::scene {

// What is wrong with an element; whoever knows where the element stands adds the place.
struct SvgError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Goes through an attribute from left to right; white space and commas separate, but need not.
class SvgScanner {
public:
    explicit SvgScanner(std::string_view text) : text_(text) {}

    bool at_end();  // skips separators
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    bool at_number() const;
    char take() { return text_[at_++]; }
    bool take_if(char wanted);  // after separators

    // Throw SvgError, with what stands there instead.
    double number();
    bool flag();              // 0 or 1, which the next number may follow at once
    std::string_view word();  // letters, digits, '-' and '_'
    void expect(char wanted);

    [[noreturn]] void refuse(std::string_view expected);

private:
    void skip_separators();

    std::string_view text_;
    std::size_t at_ = 0;
};

std::string_view trimmed(std::string_view text);

// Of ASCII letters alone, whatever the locale.
constexpr char to_lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// A length in user units: px, mm, cm, in, pt and pc at 96 pixels an inch, em at 16 pixels; a percentage is of `whole`,
// which is NaN if it is not known. Throws SvgError.
double parse_length(std::string_view text, double whole);

}  // namespace tumble::scene
