// The pages of `tumble explain`: each code that a diagnostic can have is explained, and each explained one occurs.
#include <doctest/doctest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "scene/bad_scenes.hpp"
#include "tumble/file.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_import.hpp"

using namespace tumble;

namespace {

// Warnings, or errors if there are any, of a scene or a drawing.
std::vector<Diagnostic> diagnostics_of(const std::string& text) {
    std::vector<Diagnostic> found;
    try {
        if (text.starts_with('<')) parse_svg(text, "drawing.svg");
        const auto read_none = [](const std::filesystem::path& file) -> std::string {
            throw FileError(file, "No such file or directory");
        };
        LoadOptions options;
        options.lint = true;
        options.read_included = read_none;
        parse_scene(text, "scene.json", options, &found);
    } catch (const SceneError& error) {
        found = error.diagnostics;
    }
    return found;
}

}  // namespace

TEST_CASE("the example of each page of a warning or an error has that code") {
    for (const ProblemPage& page : problems()) {
        if (page.kind == ProblemPage::Kind::exit_code) continue;
        CAPTURE(page.code);
        const std::vector<Diagnostic> found = diagnostics_of(std::string(page.example));
        CHECK(std::ranges::count(found, page.code, &Diagnostic::code) > 0);
        for (const Diagnostic& diagnostic : found)
            CHECK((diagnostic.severity == Diagnostic::Severity::error) == (page.kind == ProblemPage::Kind::error));
    }
}

TEST_CASE("each code of the source has one page, and each page a code") {
    const std::string header = read_file(TUMBLE_SOURCE_DIR "/src/scene/json/problem_codes.hpp");
    const std::regex code("std::string_view [a-z_]+ = \"([a-z-]+)\"");
    std::multiset<std::string> in_source, explained;
    for (auto match = std::sregex_iterator(header.begin(), header.end(), code); match != std::sregex_iterator();
         ++match)
        in_source.insert((*match)[1]);
    for (const ProblemPage& page : problems()) {
        if (page.kind != ProblemPage::Kind::exit_code) explained.insert(std::string(page.code));
        CHECK(find_problem(page.code) == &page);
        for (const std::string_view text : {page.title, page.meaning, page.example, page.remedy}) CHECK(!text.empty());
    }
    CHECK(in_source.size() > 20);
    CHECK(in_source == explained);
    CHECK(find_problem("no-such-code") == nullptr);
}

TEST_CASE("every error of the bad scenes has a page") {
    for (const test::BadScene& bad : test::kBadScenes)
        for (const Diagnostic& diagnostic : diagnostics_of(bad.text)) {
            CAPTURE(diagnostic.message);
            const ProblemPage* const page = find_problem(diagnostic.code);
            REQUIRE(page != nullptr);
            CHECK((page->kind == ProblemPage::Kind::error) == (diagnostic.severity == Diagnostic::Severity::error));
        }
}
