// Errors and warnings of scenes that include scenes, with their location, and the limits of includes.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "included_files.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

std::vector<Diagnostic> errors_of(const Files& files) {
    try {
        load(files);
    } catch (const SceneError& error) {
        return error.diagnostics;
    }
    return {};
}

}  // namespace

TEST_CASE("an error of an included file is shown there, with the file that includes it") {
    const std::vector<Diagnostic> errors =
        errors_of({{"main.json", "{\"format\": 1,\n \"include\": [{\"file\": \"a/car.json\"}]}"},
                   {"a/car.json", "{\"format\": 1, \"include\": [\n{\"file\": \"wheel.json\"}]}"},
                   {"a/wheel.json", "{\"format\": 1,\n \"bodies\": [{\"angel\": 3}]}"}});
    REQUIRE(errors.size() == 1);
    CHECK(to_string(errors[0]) ==
          "a/wheel.json:2:14: /bodies/0/angel: unknown key \"angel\" [body]\n"
          "   \"bodies\": [{\"angel\": 3}]}\n"
          "               ^\n"
          "  hint: did you mean 'angle'?\n"
          "  included by a/car.json:2:1\n"
          "  included by main.json:2:14");
}

TEST_CASE("errors of several parts are together at most 20") {
    std::string bodies = R"("bodies": [{"angle": null})";
    for (int i = 1; i < 15; ++i) bodies += R"(, {"angle": null})";
    const std::string bad = scene_text(bodies + "]");
    const std::vector<Diagnostic> errors = errors_of(
        {{"a.json", bad}, {"b.json", bad}, {"main.json", includes(R"({"file": "a.json"}, {"file": "b.json"})")}});
    REQUIRE(errors.size() == 20);
    CHECK(errors[14].file == "a.json");
    CHECK(errors[15].file == "b.json");
    CHECK(errors[19].hint.find("there are more errors") != std::string::npos);
}

TEST_CASE("a misspelt include hides the errors of no other") {
    const std::vector<Diagnostic> errors =
        errors_of({{"bad.json", scene_text(R"("bodies": [{"angle": null}])")},
                   {"main.json", includes(R"({"file": "no.json"}, {"path": "x"}, {"file": "bad.json"})")}});
    REQUIRE(errors.size() == 4);
    CHECK(errors[0].pointer == "/include/0/file");
    CHECK(errors[1].pointer == "/include/1");
    CHECK(errors[2].pointer == "/include/1/path");
    CHECK(errors[3].file == "bad.json");
}

TEST_CASE("warnings of a part are reported once, however often it is included") {
    const std::string hull = scene_text(
        R"("bodies": [{"shapes": [{"polygon": {"vertices": [[0, 0], [2, 0], [2, 2], [1, 0.5], [0, 2]]}}]}])");
    const Files files = {{"main.json", includes(R"({"file": "hull.json"}, {"file": "hull.json", "position": [9, 9]})")},
                         {"hull.json", hull}};
    std::vector<Diagnostic> warnings;
    parse_scene(files.at("main.json"), "main.json", with_files(files), &warnings);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].file == "hull.json");
    CHECK(warnings[0].included_by == std::vector<std::string>{"main.json:1:27"});
}

TEST_CASE("an invalid include is refused at its entry") {
    const std::string body = scene_text(
        R"("bodies": [{"name": "a", "shapes": [{"circle": {"radius": 1}}]}], "materials": {"m": {"friction": 0.1}})");
    struct Case {
        Files files;
        std::string pointer, message, hint;
    };
    const Files bodies = {{"a.json", body}};
    const auto with_main = [&](Files files, const std::string& main) {
        files["main.json"] = main;
        return files;
    };
    const std::string long_prefix(300, 'p');
    for (
        const Case& c : {
            Case{with_main({}, includes(R"({"file": "no.json"})")), "/include/0/file",
                 "no.json: No such file or directory", "folder"},
            Case{with_main({}, includes(R"({"file": "main.json"})")), "/include/0/file",
                 "includes itself: main.json > main.json", ""},
            Case{with_main({}, includes(R"({"file": "./x/../main.json"})")), "/include/0/file", "includes itself", ""},
            Case{with_main(
                     {{"b.json", includes(R"({"file": "c.json"})")}, {"c.json", includes(R"({"file": "b.json"})")}},
                     includes(R"({"file": "b.json"})")),
                 "/include/0/file", "includes itself: main.json > b.json > c.json > b.json", ""},
            Case{with_main(bodies, includes(R"({"file": "a.json"}, {"file": "a.json"})")), "/include/1",
                 R"(/bodies/0/name of a.json: "a" is already the name of /bodies/0 of a.json)", "prefix"},
            Case{with_main(bodies, scene_text(R"("bodies": [{"name": "a"}], "include": [{"file": "a.json"}])")),
                 "/include/0", R"("a" is already the name of /bodies/0)", "prefix"},
            Case{with_main(bodies, scene_text(R"("materials": {"m": {}}, "include": [{"file": "a.json"}])")),
                 "/include/0", R"(declares the material "m" with other values)", ""},
            Case{with_main(bodies, includes(R"({"file": "a.json", "prefix": ")" + long_prefix + R"("})")), "/include/0",
                 "longer than 256 bytes", ""},
            Case{
                with_main(
                    bodies,
                    includes(
                        R"({"file": "a.json", "position": [1e9, 0]}, {"file": "b.json", "position": [1e9, 0], "prefix": "b"})")),
                "/include/1/file", "b.json", ""},
            Case{with_main({{"far.json", scene_text(R"("bodies": [{"position": [1e9, 0]}])")}},
                           includes(R"({"file": "far.json", "position": [1, 0]})")),
                 "/include/0", "a position out of its range", ""},
            Case{
                with_main({{"fast.json",
                            scene_text(
                                R"("world": {"steps_per_second": 240}, "timeline": [{"every": 0.005, "spawn": {}}])")}},
                          includes(R"({"file": "fast.json"})")),
                "/include/0", "/timeline/0/every of fast.json: is shorter than a step", ""},
            Case{with_main(bodies, includes(R"({"position": [1, 0]})")), "/include/0", "the key \"file\" is missing",
                 ""},
            Case{with_main(bodies, includes(R"({"file": "a.json", "angel": 1})")), "/include/0/angel", "unknown key",
                 "angle"},
        }) {
        CAPTURE(c.files.at("main.json"));
        const std::vector<Diagnostic> errors = errors_of(c.files);
        REQUIRE(errors.size() >= 1);
        const Diagnostic& error = errors[0];
        CHECK(error.pointer == c.pointer);
        CHECK_MESSAGE(error.message.find(c.message) != std::string::npos, error.message);
        CHECK_MESSAGE(error.hint.find(c.hint) != std::string::npos, error.hint);
        CHECK(error.line == 1);
    }
}

TEST_CASE("includes that are nested too deep, or give too many bodies, are refused") {
    Files deep = {{"main.json", includes(R"({"file": "0.json"})")}};
    for (int i = 0; i < 30; ++i)
        deep[std::to_string(i) + ".json"] = includes("{\"file\": \"" + std::to_string(i + 1) + ".json\"}");
    const std::vector<Diagnostic> too_deep = errors_of(deep);
    REQUIRE(too_deep.size() == 1);
    CHECK(too_deep[0].message.find("more than 16 files deep") != std::string::npos);
    CHECK(too_deep[0].included_by.size() == 16);

    // Each file includes the next one four times: 4^15 bodies.
    Files doubled = {{"main.json", includes(R"({"file": "0.json"})")}};
    for (int i = 0; i < 15; ++i) {
        const std::string next = "{\"file\": \"" + std::to_string(i + 1) + ".json\"}";
        doubled[std::to_string(i) + ".json"] = includes(next + ", " + next + ", " + next + ", " + next);
    }
    doubled["15.json"] = scene_text(R"("bodies": [{}])");
    const std::vector<Diagnostic> too_many = errors_of(doubled);
    REQUIRE(!too_many.empty());
    CHECK(too_many[0].message.find("to more than 1000000") != std::string::npos);
}

TEST_CASE("the file after 10 000 included ones is refused, and the same file counts once") {
    std::string entries = R"({"file": "again.json"}, {"file": "again.json"})";
    for (int i = 2; i < 10000; ++i) entries += ", {\"file\": \"" + std::to_string(i) + ".json\"}";
    LoadOptions options;
    std::string with_more;  // includes a file of its own
    options.read_included = [&](const std::filesystem::path& file) {
        return file == "more.json" || file != with_more ? scene_text("") : includes(R"({"file": "more.json"})");
    };
    const auto errors = [&] {
        try {
            parse_scene(includes(entries), "main.json", options);
        } catch (const SceneError& error) {
            return error.diagnostics;
        }
        return std::vector<Diagnostic>();
    };
    CHECK(errors().empty());  // 9999 files
    with_more = "2.json";
    CHECK(errors().empty());  // 10 000
    with_more = "again.json";
    entries.replace(entries.rfind("again"), 5, "other");
    const std::vector<Diagnostic> refused = errors();
    REQUIRE(refused.size() == 1);
    CHECK(refused[0].pointer == "/include/9999/file");
    CHECK(refused[0].message.find("is one of more than 10000 included files") != std::string::npos);
}

TEST_CASE("a scene that is not read from a file includes nothing") {
    CHECK_THROWS_WITH_AS(parse_scene(includes(R"({"file": "a.json"})"), "text"),
                         doctest::Contains("only scenes that are read from files"), SceneError);
}
