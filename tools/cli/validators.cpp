#include "tools/cli/validators.hpp"

#include <CLI/CLI.hpp>

#include <charconv>
#include <limits>
#include <string>

namespace tumble::tools {

namespace {

template <class Number>
CLI::Validator from_to(Number lowest, Number highest, const std::string& wanted) {
    const auto check = [=](const std::string& text) {
        Number number{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        const bool is_number = error == std::errc{} && end == text.data() + text.size();
        return is_number && number >= lowest && number <= highest ? "" : "expected " + wanted + ", got " + text;
    };
    return {check, ""};
}

// "1000000", not "1e+06".
std::string without_exponent(double number) {
    char digits[64];
    const auto end = std::to_chars(digits, digits + sizeof digits, number, std::chars_format::fixed);
    return {digits, end.ptr};
}

}  // namespace

CLI::Validator number_from_to(double lowest, double highest) {
    return from_to(lowest, highest, "a number from " + without_exponent(lowest) + " to " + without_exponent(highest));
}

CLI::Validator whole_number_from_to(std::uint64_t lowest, std::uint64_t highest) {
    return from_to(lowest, highest, "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
}

CLI::Validator any_seed() { return whole_number_from_to(0, std::numeric_limits<std::uint64_t>::max()); }

}  // namespace tumble::tools
