// Errors in values that a program reads itself from a scene's text: refuse_value().
#include <doctest/doctest.h>

#include <optional>
#include <string>

#include "tumble/scene_file.hpp"

using namespace tumble;

namespace {

constexpr const char* kCommented = "\xEF\xBB\xBF{\"custom\": // a comment\n  {\"speed\": \"a\\u00e4b\"}}";

Diagnostic refused(const std::string& pointer, const ValueProblem& problem) {
    try {
        refuse_value(kCommented, "car.json", pointer, problem);
    } catch (const SceneError& error) {
        REQUIRE(error.diagnostics.size() == 1);
        return error.diagnostics.front();
    }
    FAIL("the value was accepted");
    return {};
}

}  // namespace

TEST_CASE("a refused value has its line and column, also after a byte-order mark and a comment") {
    const Diagnostic at_value = refused("/custom/speed", {.message = "is too fast", .hint = "at most 3"});
    CHECK(at_value.file == "car.json");
    CHECK(at_value.line == 2);
    CHECK(at_value.column == 13);
    CHECK(at_value.pointer == "/custom/speed");
    CHECK(at_value.message == "is too fast");
    CHECK(at_value.hint == "at most 3");
    CHECK(refused("/custom/speed", {.message = "no such key", .at_key = true}).column == 4);
}

TEST_CASE("a refused value inside a string counts an escape as the bytes that it stands for") {
    // "a\u00e4b": a is 1 byte, the escape stands for 2, so that b is 3 bytes from the start. The quote is in column 13.
    CHECK(refused("/custom/speed", {.message = "here", .inside = 0}).column == 14);
    CHECK(refused("/custom/speed", {.message = "here", .inside = 3}).column == 21);
}

TEST_CASE("a refused value that the text does not have is located at the innermost value that exists") {
    const Diagnostic beyond = refused("/custom/brakes/0", {.message = "needs 'brakes'"});
    CHECK(beyond.line == 2);
    CHECK(beyond.column == 3);
}
