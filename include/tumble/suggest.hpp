// "Did you mean": the nearest of the words that would have been right.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tumble {

// The candidate nearest to `word` by edits (insertion, deletion, replacement, swap of neighbours), if that is at most
// a third of its length or 1 (of one letter: none), or if they differ in case alone or one begins with the other; else
// empty. The first of equals.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates);

// "did you mean 'restitution'?", or else "expected one of: a, b, c" if the candidates are few, or nothing.
std::string suggestion(std::string_view word, std::span<const std::string_view> candidates);

// "a, b, c"
std::string join_words(std::span<const std::string_view> words);

}  // namespace tumble
