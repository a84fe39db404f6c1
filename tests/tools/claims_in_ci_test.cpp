// `check` in continuous integration: scenes without claims, times, --fail-fast, and --update of hashes.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <regex>
#include <string>

#include "process.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::Process;
using tumble::test::read_text;
using tumble::test::run_tumble;
using tumble::test::tumble_command;

namespace {

// A falling ball, with these claims.
std::string ball_scene(const std::string& claims) {
    return R"({"format": 1, "world": {"duration": 1}, "bodies": [
        {"name": "ball", "shapes": [{"circle": {"radius": 1}}]}], "expect": [)" +
           claims + "]}";
}

constexpr const char* kHolds = R"({"body": "ball", "height": [-9, 0]})";
constexpr const char* kFails = R"({"body": "ball", "height": [1, 2]})";

}  // namespace

TEST_CASE("check says that a scene has no claims, and --require-claims refuses it") {
    const Folder folder;
    const std::string none = folder.write("none.json", ball_scene("")),
                      some = folder.write("a.json", ball_scene(kHolds));
    const Answer silent = run_tumble({"check", none, some});
    CHECK(silent.code == 0);
    CHECK(silent.err.find("none.json: the scene has no claims") != std::string::npos);
    CHECK(silent.err.find("a.json") == std::string::npos);
    const Answer required = run_tumble({"check", none, some, "--require-claims", "--json"});
    CHECK(required.code == 7);
    const json document = json::parse(required.out);
    CHECK(document["scenes"][0]["passed"] == false);
    CHECK(document["scenes"][0]["failure"].get<std::string>().find("has no claims") == 0);
    CHECK_FALSE(document["scenes"][0].contains("error"));
    const std::string junit = (folder / "j.xml").string();
    const Answer text = run_tumble({"check", none, "--require-claims", "--junit", junit});
    CHECK(text.out.starts_with(none + ": failed: has no claims, "));
    CHECK(read_text(junit).find("tests=\"1\" failures=\"1\" errors=\"0\"") != std::string::npos);
    CHECK(read_text(junit).find("<failure message=\"has no claims, ") != std::string::npos);
    CHECK(document["scenes"][1]["passed"] == true);
    CHECK(run_tumble({"check", some, "--require-claims"}).code == 0);
}

TEST_CASE("the JUnit report has the time of each scene, and the sums of all") {
    const Folder folder;
    const std::string two = folder.write("two.json", ball_scene(std::string(kHolds) + ", " + kFails)),
                      none = folder.write("none.json", ball_scene("")), junit = (folder / "j.xml").string();
    CHECK(run_tumble({"check", two, none, "--junit", junit}).code == 7);
    const std::string text = read_text(junit);
    const auto times_of = [&text](const std::string& element) {
        std::vector<double> times;
        const std::regex time("<" + element + " [^>]*time=\"([^\"]*)\"");
        for (std::sregex_iterator found(text.begin(), text.end(), time), end; found != end; ++found)
            times.push_back(std::stod((*found)[1]));
        return times;
    };
    const std::vector<double> suites = times_of("testsuite"), cases = times_of("testcase"),
                              all = times_of("testsuites");
    REQUIRE(suites.size() == 2);
    REQUIRE(cases.size() == 3);
    REQUIRE(all.size() == 1);
    CHECK(suites[0] > 0.0);
    CHECK(cases[0] == suites[0]);
    CHECK(cases[1] == 0.0);
    CHECK(cases[2] == suites[1]);  // a scene without claims is a case of its own
    CHECK(all[0] == suites[0] + suites[1]);
    CHECK(text.find("<testsuites name=\"tumble\" tests=\"3\" failures=\"1\" errors=\"0\"") != std::string::npos);
}

TEST_CASE("--fail-fast begins no scene after one that fails") {
    const Folder folder;
    const std::string good = folder.write("good.json", ball_scene(kHolds)),
                      bad = folder.write("bad.json", ball_scene(kFails)), junit = (folder / "j.xml").string();
    const Answer answer = run_tumble({"check", good, bad, good, "--jobs", "1", "--fail-fast", "--junit", junit});
    CHECK(answer.code == 7);
    CHECK(answer.out.ends_with(good + ": skipped after a failure\n"));
    CHECK(answer.err.empty());
    CHECK(read_text(junit).find("tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"1\"") != std::string::npos);
    CHECK(read_text(junit).find("<skipped/>") != std::string::npos);
    const json document = json::parse(run_tumble({"check", bad, good, "--jobs", "1", "--fail-fast", "--json"}).out);
    CHECK(document["scenes"][1]["skipped"] == true);
    CHECK(document["scenes"][1]["passed"] == false);
    CHECK(document["scenes"][0]["skipped"] == false);
    CHECK(run_tumble({"check", bad, good, "--jobs", "1"}).out.find(good + ": 1 of 1 claim holds") != std::string::npos);
}

TEST_CASE("--update writes the hashes that were found, and nothing else") {
    const Folder folder;
    const std::string golden = R"({"state_hash": "0000000000000000"})",
                      early = R"({"state_hash": "0000000000000000", "at": 0.5})";
    const std::string text =
        "// golden\n" + ball_scene("\n  " + std::string(kHolds) + ", // kept\n  " + golden + ",\n  " + early);
    const std::string scene = folder.write("scene.json", text), link = (folder / "link.json").string();
    fs::create_symlink(scene, link);
    CHECK(run_tumble({"check", scene}).code == 7);
    CHECK(run_tumble({"check", scene, "--update", "--set", "/world/substeps=8"}).code == 2);
    CHECK(Process(tumble_command({"check", "-", "--update"}), ".", text).wait().code == 2);
    CHECK(read_text(scene) == text);

    const Answer updated = run_tumble({"check", link, "--update", "--json"});
    CHECK_MESSAGE(updated.code == 0, updated.out);
    const json changes = json::parse(updated.out)["scenes"][0]["updated"];
    REQUIRE(changes.size() == 2);
    CHECK(changes[0]["pointer"] == "/expect/1/state_hash");
    CHECK(changes[0]["before"] == "0000000000000000");
    CHECK(fs::is_symlink(link));
    const std::string end = changes[0]["after"], half = changes[1]["after"];
    CHECK(end != half);
    std::string expected = text;
    expected.replace(expected.find("0000000000000000"), 16, end);
    expected.replace(expected.find("0000000000000000"), 16, half);
    CHECK(read_text(scene) == expected);

    const Answer again = run_tumble({"check", scene, "--update"});
    CHECK(again.code == 0);
    CHECK(again.out.find("updated") == std::string::npos);
    const std::string failing = folder.write("failing.json", ball_scene(golden + ", " + kFails));
    const Answer both = run_tumble({"check", failing, "--update"});
    CHECK(both.code == 7);
    CHECK(both.out.find("/expect/0/state_hash updated from 0000000000000000 to " + end) != std::string::npos);
}

TEST_CASE("a scene file that --update cannot write is an error of its scene, and all reports are written") {
    const Folder folder;
    const std::string text = ball_scene(R"({"state_hash": "0000000000000000"})");
    const std::string kept = folder.write("kept.json", text), other = folder.write("other.json", text);
    // The temporary file beside a name of 250 bytes has a longer name than file systems allow.
    const std::string blocked = folder.write(std::string(245, 'x') + ".json", text);
    const std::string junit = (folder / "j.xml").string();
    const Answer answer = run_tumble({"check", kept, blocked, other, "--update", "--json", "--junit", junit});
    CHECK(answer.code == 4);
    REQUIRE_MESSAGE(!answer.out.empty(), answer.err);
    const json scenes = json::parse(answer.out)["scenes"];
    REQUIRE(scenes.size() == 3);
    CHECK(scenes[0]["updated"].size() == 1);
    CHECK(scenes[1]["error"].get<std::string>().find("the hashes could not be written: ") == 0);
    CHECK_FALSE(scenes[1].contains("updated"));
    CHECK(scenes[1]["expectations"][0]["passed"] == false);
    CHECK(scenes[2]["updated"].size() == 1);
    CHECK(read_text(blocked) == text);
    CHECK(read_text(junit).find("tests=\"4\" failures=\"1\" errors=\"1\"") != std::string::npos);
    CHECK(run_tumble({"check", blocked, "--update"}).out.find(": 0 of 1 claim holds") != std::string::npos);
}
