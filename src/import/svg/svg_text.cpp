// Numbers are read by std::from_chars, which does not depend on the locale.
#include "import/svg/svg_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "scene/json/json_text.hpp"

namespace tumble::scene {

namespace {

constexpr std::string_view kSpace = " \t\r\n\f";

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_word(char c) { return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_'; }

}  // namespace

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kSpace);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

void SvgScanner::skip_separators() {
    while (at_ < text_.size() && (kSpace.find(text_[at_]) != std::string_view::npos || text_[at_] == ',')) ++at_;
}

bool SvgScanner::at_end() {
    skip_separators();
    return at_ == text_.size();
}

bool SvgScanner::at_number() const { return is_digit(peek()) || peek() == '-' || peek() == '+' || peek() == '.'; }

bool SvgScanner::take_if(char wanted) {
    skip_separators();
    if (peek() != wanted) return false;
    ++at_;
    return true;
}

double SvgScanner::number() {
    skip_separators();
    std::size_t from = at_;
    const bool has_sign = peek() == '+' || peek() == '-';
    const bool negative = peek() == '-';
    if (has_sign) ++from;
    // from_chars would accept "inf" and "nan".
    const bool starts = from < text_.size() && (is_digit(text_[from]) || text_[from] == '.');
    double value = 0.0;
    const char* begin = text_.data() + from;
    const auto [end, failure] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (!starts || failure == std::errc::invalid_argument) refuse("a number");
    if (failure == std::errc::result_out_of_range) throw SvgError("a number is out of range");
    at_ = static_cast<std::size_t>(end - text_.data());
    return negative ? -value : value;
}

bool SvgScanner::flag() {
    skip_separators();
    if (peek() != '0' && peek() != '1') refuse("a flag, 0 or 1");
    return take() == '1';
}

std::string_view SvgScanner::word() {
    skip_separators();
    const std::size_t from = at_;
    while (at_ < text_.size() && is_word(text_[at_])) ++at_;
    if (at_ == from) refuse("a word");
    return text_.substr(from, at_ - from);
}

void SvgScanner::expect(char wanted) {
    if (!take_if(wanted)) refuse(std::string("'") + wanted + '\'');
}

void SvgScanner::refuse(std::string_view expected) {
    constexpr std::size_t kShown = 12;
    const std::string found = at_ < text_.size() ? quoted(std::string(text_.substr(at_, kShown))) : "the end";
    throw SvgError("expected " + std::string(expected) + " at character " + std::to_string(at_ + 1) + ", got " + found);
}

double parse_length(std::string_view text, double whole) {
    static constexpr std::array<std::pair<std::string_view, double>, 9> kUnits{{{"", 1.0},
                                                                                {"px", 1.0},
                                                                                {"in", 96.0},
                                                                                {"cm", 96.0 / 2.54},
                                                                                {"mm", 96.0 / 25.4},
                                                                                {"pt", 96.0 / 72.0},
                                                                                {"pc", 16.0},
                                                                                {"em", 16.0},
                                                                                {"ex", 8.0}}};
    SvgScanner scanner(text);
    const double value = scanner.number();
    if (scanner.take_if('%')) {
        if (std::isnan(whole)) throw SvgError("a percentage needs a width and a height, or a viewBox, of the drawing");
        return value * whole / 100.0;
    }
    const std::string_view unit = scanner.at_end() ? "" : scanner.word();
    for (const auto& [name, pixels] : kUnits)
        if (unit == name) return value * pixels;
    throw SvgError("unknown unit of length " + quoted(std::string(unit)));
}

}  // namespace tumble::scene
