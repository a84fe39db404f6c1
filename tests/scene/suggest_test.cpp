// Suggestions for misspelt words.
#include "tumble/suggest.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <vector>

using namespace tumble;

TEST_CASE("the word with the fewest edits is suggested, if the edits are few") {
    constexpr std::array<std::string_view, 4> kWords = {"restitution", "radius", "rolling_resistance", "size"};
    CHECK(nearest_word("restituton", kWords) == "restitution");  // one deletion
    CHECK(nearest_word("raduis", kWords) == "radius");           // one swap of neighbours
    CHECK(nearest_word("sise", kWords) == "size");               // one replacement
    CHECK(nearest_word("rolling", kWords) == "rolling_resistance");
    CHECK(nearest_word("banana", kWords).empty());
    CHECK(nearest_word("", kWords).empty());
    CHECK(nearest_word(std::string(100000, 'x'), kWords).empty());
}

TEST_CASE("a swap of neighbours counts as one edit, not two") {
    constexpr std::array<std::string_view, 1> kWords = {"at"};
    CHECK(nearest_word("ta", kWords) == "at");  // a word of two letters may have one edit
    CHECK(nearest_word("tx", kWords).empty());  // two edits
}

TEST_CASE("a single letter matches only its other case, and an empty list gives no suggestion") {
    constexpr std::array<std::string_view, 2> kWords = {"a", "B"};
    CHECK(nearest_word("c", kWords).empty());
    CHECK(nearest_word("b", kWords) == "B");
    CHECK(suggestion("c", {}).empty());
}

TEST_CASE("without a near word, a short list is shown and a long one is not") {
    constexpr std::array<std::string_view, 2> kFew = {"grid", "ring"};
    CHECK(suggestion("zzzzzz", kFew) == "expected one of: grid, ring");
    const std::vector<std::string_view> many(20, "word");
    CHECK(suggestion("zzzzzz", many).empty());
}
