// Numbers, lengths and words in the attributes of an SVG file.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace tumble::scene {

// An error in an element. The importer adds the line and column of the element.
struct SvgError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Scans an attribute from left to right. White space and commas between values are optional.
class SvgScanner {
public:
    explicit SvgScanner(std::string_view text) : text_(text) {}

    bool at_end();  // skips separators
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    bool at_number() const;
    char take() { return text_[at_++]; }
    bool take_if(char wanted);  // after separators

    // Throw SvgError, with the text that was found instead.
    double number();
    bool flag();              // 0 or 1; the next number may follow without a separator
    std::string_view word();  // letters, digits, '-' and '_'
    void expect(char wanted);

    [[noreturn]] void refuse(std::string_view expected);

private:
    void skip_separators();

    std::string_view text_;
    std::size_t at_ = 0;
};

std::string_view trimmed(std::string_view text);

// Converts ASCII letters only; independent of the locale.
constexpr char to_lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// A length in user units: px, mm, cm, in, pt and pc at 96 pixels an inch, em at 16 pixels. A percentage refers to
// `whole`, which is NaN if it is unknown. Throws SvgError.
double parse_length(std::string_view text, double whole);

}  // namespace tumble::scene
