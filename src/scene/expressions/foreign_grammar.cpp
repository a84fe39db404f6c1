#include "scene/expressions/foreign_grammar.hpp"

#include <algorithm>
#include <array>

#include "scene/expressions/vocabulary.hpp"
#include "tumble/suggest.hpp"

namespace tumble::scene {

std::string_view own_word(std::string_view sign) {
    if (sign == "&&" || sign == "&") return "write 'and'";
    if (sign == "||" || sign == "|") return "write 'or'";
    if (sign == "!") return "write 'not'";
    if (sign == "=") return "a comparison is written ==";
    if (sign == "**") return "a power is written ^";
    return {};
}

bool is_touch_word(std::string_view word) {
    constexpr std::array<std::string_view, 10> kWords{"contact", "contacts", "collides", "collision", "hit",
                                                      "hits",    "overlaps", "touch",    "touches",   "touching"};
    return std::ranges::find(kWords, word) != kWords.end();
}

std::string own_function(const std::string& name) {
    if (name == "where") return "write if(condition, a, b)";
    if (name == "clip") return "write clamp(a, low, high)";
    if (is_touch_word(name)) return "write touching(a, b)";
    return suggestion(name, names_of(function_words()));
}

}  // namespace tumble::scene
