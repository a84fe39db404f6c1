// Which replays `run` refuses, and where it writes them.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "process.hpp"

namespace fs = std::filesystem;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::read_text;
using tumble::test::run_tumble;

TEST_CASE("an existing page is replaced only by --force") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    const std::string mine = folder.write("page.html", "mine");
    const std::vector<std::string> arguments{"run",        scene, "--no-frames", "-o", (folder / "out").string(),
                                             "--duration", "0.1", "--replay",    mine};
    CHECK(run_tumble(arguments).code == 4);
    CHECK(read_text(mine) == "mine");
    std::vector<std::string> forced = arguments;
    forced.push_back("--force");
    CHECK(run_tumble(forced).code == 0);
    CHECK(read_text(mine).starts_with("<!doctype html>"));
}

TEST_CASE("a replay that is refused leaves the results of an earlier run") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    const std::string page = (folder / "page.html").string();
    const auto code_of = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{
            "run", scene, "--no-frames", "--duration", "0.1", "-o", (folder / "out").string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_tumble(arguments).code;
    };
    REQUIRE(code_of({"--replay", page}) == 0);
    const std::string summary = read_text(folder / "out/summary.json"), first = read_text(page);
    const std::string file = folder.write("file", "");
    CHECK(code_of({"--force", "--duration", "900000", "--replay", page}) == 2);
    CHECK(code_of({"--force", "--replay", file + "/page.html"}) == 4);
    CHECK(code_of({"--force", "--trajectory", file + "/table.csv"}) == 4);
    CHECK(code_of({"--force", "--replay", folder.path().string()}) == 4);
    CHECK(code_of({"--force", "--no-replay-contacts"}) == 2);
    CHECK(read_text(folder / "out/summary.json") == summary);
    CHECK(fs::exists(folder / "out/events.csv"));
    CHECK(read_text(page) == first);
}

TEST_CASE("a page goes to standard output") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    for (const std::string name : {"-", "/dev/stdout"}) {
        CAPTURE(name);
        const Answer answer = run_tumble({"run", scene, "--no-frames", "--force", "--duration", "0.1", "-o",
                                          (folder / "out").string(), "--replay", name});
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        const std::string page = (folder / "page.html").string();
        REQUIRE(run_tumble({"run", scene, "--no-frames", "--force", "--duration", "0.1", "-o",
                            (folder / "out").string(), "--replay", page})
                    .code == 0);
        CHECK(answer.out == read_text(page));
    }
}

TEST_CASE("a replay of more poses than a browser can unpack is refused, with the duration that is not") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    const std::string page = (folder / "page.html").string();
    const auto answer_of = [&](const std::string& duration) {
        return run_tumble({"run", scene, "--no-frames", "-o", (folder / "out").string(), "--duration", duration,
                           "--replay", page, "--set", "/world/steps_per_second=30"});
    };
    const Answer answer = answer_of("900000");
    CHECK(answer.code == 2);
    // 30 million poses of 3 bodies are 10 million states: 9 999 999 steps at 30 Hz, rounded down to 10 ms.
    CHECK_MESSAGE(answer.err.find("at most 333333.3 s") != std::string::npos, answer.err);
    CHECK(!fs::exists(folder / "out"));
    CHECK(answer_of("333333.34").code == 2);
}
