// Splitting the text of an object into its members.
#include "tools/query/json_members.hpp"

#include <doctest/doctest.h>

using namespace tumble::tools;

TEST_CASE("members are found whatever their values contain") {
    const auto members = split_members(R"( {"a": {"x": [1, {"}": ","}]} , "b":"\"}," ,"c":-1e3} )");
    REQUIRE(members);
    REQUIRE(members->size() == 3);
    CHECK((*members)[0].key == "a");
    CHECK((*members)[0].value == R"({"x": [1, {"}": ","}]} )");
    CHECK((*members)[1].value == R"("\"}," )");
    CHECK((*members)[2].key == "c");
    CHECK((*members)[2].value == "-1e3");
    CHECK(split_members("{}")->empty());
}

TEST_CASE("text that is not an object is not split") {
    for (const char* text : {"", "1", "[1]", "{", "{\"a\"}", "{\"a\":}", "{\"a\":1", "{\"a\":1,}", "{a:1}",
                             "{\"a\":1}x", "{\"a\":\"x}", "{\"a\":[1}", "{\"a\":1]"})
        CHECK_MESSAGE(!split_members(text), text);
}
