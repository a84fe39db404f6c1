// Suggestions for misspelt words: the nearest of the valid ones.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tumble {

// The candidate nearest to `word` by edits (insertion, deletion, replacement, swap of neighbours), the first of equally
// near ones. At most max(1, length / 3) edits are allowed, for a single letter none. Otherwise a candidate qualifies if
// it differs in case only, or if one of the two words begins with the other.
// Empty if none qualifies.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates);

// "did you mean 'restitution'?" or, without a near candidate, "expected one of: a, b, c" if there are at most 16.
// Otherwise empty.
std::string suggestion(std::string_view word, std::span<const std::string_view> candidates);

// "a, b, c"
std::string join_words(std::span<const std::string_view> words);

}  // namespace tumble
