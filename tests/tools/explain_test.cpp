// `explain`, and the codes in the messages of other commands.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <regex>
#include <set>
#include <string>

#include "process.hpp"
#include "tumble/scene_file.hpp"

using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::run_tumble;

TEST_CASE("explain prints the meaning, an example and the remedy of a code") {
    for (const tumble::ProblemPage& page : tumble::problems()) {
        const json printed = json::parse(run_tumble({"explain", std::string(page.code), "--json"}).out);
        CHECK(printed["code"] == page.code);
        CHECK(printed["meaning"] == page.meaning);
        CHECK(printed["example"] == page.example);
        CHECK(printed["remedy"] == page.remedy);
    }
    const Answer text = run_tumble({"explain", "stiff-spring"});
    CHECK(text.code == 0);
    for (const char* part : {"warning stiff-spring", "Meaning\n", "Example\n", "Remedy\n", "\"hertz\": 500"})
        CHECK_MESSAGE(text.out.find(part) != std::string::npos, part);
    const Answer list = run_tumble({"explain"});
    for (const tumble::ProblemPage& page : tumble::problems())
        CHECK(list.out.find(std::string(page.code) + " ") != std::string::npos);
    CHECK(json::parse(run_tumble({"explain", "--json"}).out).size() == tumble::problems().size());
}

TEST_CASE("an option that a page names is one of a command that the page names") {
    const std::regex word("--[a-z-]+|[a-z]+");
    for (const tumble::ProblemPage& page : tumble::problems()) {
        CAPTURE(page.code);
        const std::string text =
            std::string(page.meaning) + " " + std::string(page.example) + " " + std::string(page.remedy);
        std::set<std::string> options;
        std::string help;  // of all words that are commands
        for (auto match = std::sregex_iterator(text.begin(), text.end(), word); match != std::sregex_iterator();
             ++match)
            if (match->str().starts_with("--")) options.insert(match->str());
        if (options.empty()) continue;
        for (const char* const command : {"check", "diff", "import", "parity", "physics", "run", "shot", "validate"})
            if (text.find(command) != std::string::npos) help += run_tumble({command, "--help"}).out;
        for (const std::string& option : options) CHECK_MESSAGE(help.find(option) != std::string::npos, option);
    }
}

TEST_CASE("explain takes a code as messages and shells show it") {
    const auto page = [](const std::string& code) { return run_tumble({"explain", code}).out; };
    CHECK(page("7") == page("exit-7"));
    CHECK(page("143") == page("exit-143"));
    CHECK(page("[stiff-spring]") == page("stiff-spring"));
    CHECK(page("Stiff-Spring") == page("stiff-spring"));
    CHECK(run_tumble({"explain", "99"}).err.find("there is no code '99'") != std::string::npos);
    // What else the table of exit codes names.
    for (const char* const cause : {"sweep", "--fail-on-findings"})
        CHECK_MESSAGE(page("exit-7").find(cause) != std::string::npos, cause);
}

TEST_CASE("explain refuses an unknown code and names the nearest") {
    const Answer answer = run_tumble({"explain", "stiff-sprng"});
    CHECK(answer.code == 2);
    CHECK(answer.err.find("did you mean 'stiff-spring'?") != std::string::npos);
}

TEST_CASE("each exit code has a page") {
    const std::string header = tumble::test::read_text(TUMBLE_SOURCE_DIR "/tools/cli/exit_code.hpp");
    const std::regex code(" = ([0-9]+),");
    std::set<std::string> codes, pages;
    for (auto match = std::sregex_iterator(header.begin(), header.end(), code); match != std::sregex_iterator();
         ++match)
        if ((*match)[1] != "0") codes.insert("exit-" + (*match)[1].str());
    for (const tumble::ProblemPage& page : tumble::problems())
        if (page.kind == tumble::ProblemPage::Kind::exit_code) pages.insert(std::string(page.code));
    CHECK(codes.size() == 9);
    CHECK(pages == codes);
}

TEST_CASE("validate states the code of each warning and error") {
    const Folder folder;
    const std::string warned =
        folder.write("warned.json", R"({"format": 1, "bodies": [{"type": "static", "velocity": [1, 0]}]})");
    const std::string wrong = folder.write("wrong.json", R"({"format": 1, "world": {"substeps": -1}})");
    const json scenes = json::parse(run_tumble({"validate", "--json", warned, wrong}).out)["scenes"];
    CHECK(scenes[0]["diagnostics"][0]["code"] == "static-velocity");
    CHECK(scenes[1]["diagnostics"][0]["code"] == "world");
    CHECK(run_tumble({"validate", warned}).err.find("[static-velocity]") != std::string::npos);
}
