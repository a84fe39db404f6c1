// Optimal string alignment distance by three rows of the dynamic program (Damerau 1964, Wagner and Fischer 1974).

#include "tumble/suggest.hpp"

#include <algorithm>
#include <vector>

namespace tumble {

namespace {

constexpr std::size_t kLongestWord = 64;  // bytes; longer words get no suggestion, which bounds the work
constexpr std::size_t kShortList = 16;

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        std::swap(before, above);
        std::swap(above, row);
    }
    return above[b.size()];
}

bool is_same_but_for_case(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::ranges::equal(a, b, {}, lower, lower);
}

bool begins_like(std::string_view a, std::string_view b) {
    return std::min(a.size(), b.size()) >= 3 && (a.starts_with(b) || b.starts_with(a));
}

}  // namespace

std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates) {
    if (word.size() > kLongestWord) return {};
    for (const std::string_view candidate : candidates)
        if (is_same_but_for_case(word, candidate)) return candidate;
    std::string_view nearest;
    // A candidate must need fewer edits than this. For a single letter no edit is allowed.
    std::size_t least = word.size() < 2 ? 1 : std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string_view candidate : candidates) {
        if (candidate.size() > kLongestWord) continue;
        const std::size_t edits = edit_distance(word, candidate);
        if (edits >= least) continue;
        least = edits;
        nearest = candidate;
    }
    if (!nearest.empty()) return nearest;
    const auto similar = std::find_if(candidates.begin(), candidates.end(),
                                      [&](std::string_view candidate) { return begins_like(word, candidate); });
    return similar == candidates.end() ? std::string_view{} : *similar;
}

std::string suggestion(std::string_view word, std::span<const std::string_view> candidates) {
    const std::string_view nearest = nearest_word(word, candidates);
    if (!nearest.empty()) return "did you mean '" + std::string(nearest) + "'?";
    if (candidates.empty() || candidates.size() > kShortList) return {};
    return "expected one of: " + join_words(candidates);
}

std::string join_words(std::span<const std::string_view> words) {
    std::string text;
    for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
    return text;
}

}  // namespace tumble
