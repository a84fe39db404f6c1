// `tumble shrink`: planted failures, the files it writes, its log, and wrong arguments.
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include "planted_failures.hpp"
#include "process.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::planted_failures;
using tumble::test::planted_scene;
using tumble::test::PlantedFailure;
using tumble::test::Process;
using tumble::test::read_text;
using tumble::test::run_tumble;
using tumble::test::tumble_command;

namespace {

constexpr int kFewBodies = 30;  // besides the core, where the size of the scene does not matter

const PlantedFailure& planted(const std::string& title) {
    for (const PlantedFailure& failure : planted_failures())
        if (failure.title == title) return failure;
    FAIL("no failure is called " << title);
    return planted_failures().front();
}

std::vector<std::string> shrink_arguments(const PlantedFailure& failure, const std::string& scene,
                                          const fs::path& output, const std::string& jobs = "2") {
    std::vector<std::string> arguments = {"shrink",        scene,    "--fails", failure.command, "-o",
                                          output.string(), "--jobs", jobs,      "--json"};
    if (failure.same_output) arguments.emplace_back("--same-output");
    return arguments;
}

// How a scene fails, found without the shrinker: the failed claim with its finding, or the end of the command; empty if
// it does not fail or is no valid scene.
std::string failure_of(const PlantedFailure& failure, const json& scene) {
    const Folder folder;
    const std::string file = folder.write("scene.json", scene.dump());
    if (run_tumble({"validate", file}).code != 0) return "";
    if (failure.command != "check") {
        const std::string command = std::regex_replace(failure.command, std::regex("\\{\\}"), file);
        const Answer answer = tumble::test::run({"/bin/sh", "-c", command});
        const std::string line = std::regex_replace(answer.err, std::regex(file), "FILE");
        return answer.code == 0 ? "" : std::to_string(answer.code) + (failure.same_output ? line : "");
    }
    const json check = json::parse(run_tumble({"check", file, "--json"}).out)["scenes"][0];
    std::string text = check.value("error", "");
    for (const json& claim : check["expectations"])
        if (!claim["passed"]) text += claim["claim"].get<std::string>() + ": " + claim["finding"].get<std::string>();
    return std::regex_replace(text, std::regex("-?\\b[0-9][0-9.]*(e-?[0-9]+)?"), "#");
}

bool names(const json& element, const std::string& name) {
    return !name.empty() && element.dump().find("\"" + name + "\"") != std::string::npos;
}

// The scene without one element of a list, and without the joints and events that name it.
json without(json scene, const std::string& list, std::size_t index) {
    const std::string name = list == "timeline" ? "" : scene[list][index].value("name", "");
    scene[list].erase(index);
    for (const char* other : {"joints", "timeline"})
        for (std::size_t i = scene.contains(other) ? scene[other].size() : 0; i-- > 0;) {
            const bool is_of_it = names(scene[other][i], name) ||
                                  (!name.empty() && scene[other][i].value("when", "").find(name) != std::string::npos);
            if (is_of_it) scene[other].erase(i);
        }
    return scene;
}

void check_one_minimal(const PlantedFailure& failure, const json& minimal, const std::string& wanted) {
    for (const char* list : {"bodies", "joints", "timeline"})
        for (std::size_t i = 0; minimal.contains(list) && i < minimal[list].size(); ++i)
            CHECK_MESSAGE(failure_of(failure, without(minimal, list, i)) != wanted,
                          list << " " << i << " is not needed: " << minimal.dump(2));
    for (std::size_t i = 0; i < minimal["bodies"].size(); ++i)
        for (std::size_t k = 0; k < minimal["bodies"][i].value("shapes", json::array()).size(); ++k) {
            json fewer = minimal;
            fewer["bodies"][i]["shapes"].erase(k);
            CHECK_MESSAGE(failure_of(failure, fewer) != wanted, "a shape is not needed: " << minimal.dump(2));
        }
}

}  // namespace

TEST_CASE("of twenty planted failures at least 95 % of the bodies go, in at most 200 runs, and the rest is 1-minimal") {
    const Folder folder;
    CHECK(planted_failures().size() == 20);
    for (std::size_t i = 0; i < planted_failures().size(); i += tumble::test::case_stride()) {
        const PlantedFailure& failure = planted_failures()[i];
        CAPTURE(failure.title);
        const std::string scene = folder.write("scene.json", planted_scene(failure).dump());
        const fs::path output = folder / ("min" + std::to_string(i) + ".json");
        const Answer answer = run_tumble(shrink_arguments(failure, scene, output));
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        const json report = json::parse(answer.out);
        const json& after = report["after"];
        const json minimal = json::parse(read_text(output));
        MESSAGE(failure.title << ": " << report["before"]["bodies"] << " -> " << after["bodies"] << " bodies, "
                              << report["before"]["bytes"] << " -> " << after["bytes"] << " bytes, " << report["runs"]
                              << " runs");
        CHECK(report["before"]["bodies"] == 97 + failure.bodies.size());
        CHECK(after["bodies"] <= failure.most_bodies);
        CHECK(after["joints"] <= failure.joints.size());
        CHECK(after["events"] <= failure.events.size());
        CHECK(report["runs"] <= 200);
        CHECK(report["complete"] == true);
        CHECK(minimal["bodies"].size() == after["bodies"]);
        const std::string wanted = failure_of(failure, planted_scene(failure));
        CHECK_FALSE(wanted.empty());
        CHECK(failure_of(failure, minimal) == wanted);
        check_one_minimal(failure, minimal, wanted);
        CHECK(read_text(folder / ("min" + std::to_string(i) + ".png")).substr(1, 3) == "PNG");
        CHECK(run_tumble({"fmt", output.string()}).out == read_text(output));
    }
}

// Three overlaps: the deepest of them is not so in a scene without its bodies, and other bodies are then found.
TEST_CASE("with --any-body the finding may be about other bodies") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", R"({"format": 1, "world": {"duration": 0.1}, "bodies": [
        {"name": "a", "position": [0, 0], "shapes": [{"circle": {"radius": 1}}]},
        {"name": "b", "position": [1.2, 0], "shapes": [{"circle": {"radius": 1}}]},
        {"name": "c", "position": [2.6, 0], "shapes": [{"circle": {"radius": 1}}]},
        {"name": "d", "position": [4.2, 0], "shapes": [{"circle": {"radius": 1}}]}],
      "expect": [{"max_penetration": 0.1}]})");
    const auto kept_of = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"shrink", scene, "-o",      (folder / "min.json").string(),
                                           "--keep", "c",   "--force", "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Answer answer = run_tumble(arguments);
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        const bool is_masked =
            json::parse(answer.out)["failure"].get<std::string>().find("'*' and '*' overlap") != std::string::npos;
        CHECK(is_masked == !more.empty());
        return json::parse(read_text(folder / "min.json"))["bodies"].size();
    };
    CHECK(kept_of({}) == 3);  // a and b besides c
    CHECK(kept_of({"--any-body"}) == 2);
    CHECK(run_tumble(
              {"shrink", scene, "-o", (folder / "min.json").string(), "--force", "--any-body", "--fails", "true {}"})
              .code == 2);
}

TEST_CASE("one job and several shrink to the same bytes, with the same number of runs") {
    for (const char* title : {"touches", "signal"}) {
        const Folder folder;
        const PlantedFailure& failure = planted(title);
        const std::string scene = folder.write("scene.json", planted_scene(failure, kFewBodies).dump());
        const Answer one = run_tumble(shrink_arguments(failure, scene, folder / "one.json", "1"));
        const Answer three = run_tumble(shrink_arguments(failure, scene, folder / "three.json", "3"));
        REQUIRE(one.code == 0);
        REQUIRE(three.code == 0);
        CHECK(read_text(folder / "one.json") == read_text(folder / "three.json"));
        CHECK(read_text(folder / "one.png") == read_text(folder / "three.png"));
        CHECK(json::parse(one.out)["runs"] == json::parse(three.out)["runs"]);
        CHECK(json::parse(one.out)["new_runs"] == json::parse(one.out)["runs"]);
    }
}

TEST_CASE("a search that is killed continues to the same bytes, and one that is complete needs no run") {
    const PlantedFailure& failure = planted("expression");
    const Folder folder;
    const std::string scene = folder.write("scene.json", planted_scene(failure, kFewBodies).dump());
    const Answer whole = run_tumble(shrink_arguments(failure, scene, folder / "whole.json"));
    REQUIRE(whole.code == 0);
    const std::size_t log_size = read_text(folder / "whole.shrink.log").size();
    // A log that is cut off at any place, also within a line, is what a kill leaves.
    for (const std::size_t size : {log_size / 3, log_size / 2, log_size - 2}) {
        fs::copy_file(folder / "whole.shrink.log", folder / "part.shrink.log", fs::copy_options::overwrite_existing);
        fs::resize_file(folder / "part.shrink.log", size);
        const Answer rest = run_tumble(shrink_arguments(failure, scene, folder / "part.json"));
        REQUIRE_MESSAGE(rest.code == 0, rest.err);
        CHECK(read_text(folder / "part.json") == read_text(folder / "whole.json"));
        CHECK(json::parse(rest.out)["runs"] == json::parse(whole.out)["runs"]);
        CHECK(json::parse(rest.out)["new_runs"] < json::parse(whole.out)["new_runs"]);
        CHECK(json::parse(rest.out)["new_runs"] > 0);
    }
    const Answer again = run_tumble(shrink_arguments(failure, scene, folder / "part.json"));
    CHECK(json::parse(again.out)["new_runs"] == 0);
    CHECK(read_text(folder / "part.json") == read_text(folder / "whole.json"));
}

TEST_CASE("a signal ends the search with the smallest scene so far, which the same command continues") {
    PlantedFailure slow = planted("exit code");
    slow.command = "sleep 0.05; " + slow.command;
    const Folder folder;
    const std::string scene = folder.write("scene.json", planted_scene(slow, kFewBodies).dump());
    const fs::path output = folder / "out" / "planted.json", log = folder / "out" / "planted.shrink.log";
    for (const int signal : {SIGINT, SIGKILL}) {
        Process process(tumble_command(shrink_arguments(slow, scene, folder / "out", "1")));
        const std::uintmax_t before = fs::exists(log) ? fs::file_size(log) : 0;
        for (int i = 0; i < 6000 && process.is_running() && (!fs::exists(log) || fs::file_size(log) < before + 200);
             ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        const Answer second = run_tumble(shrink_arguments(slow, scene, folder / "out", "1"));
        CHECK(second.code == 4);
        CHECK(second.err.find("another process") != std::string::npos);
        process.send_signal(signal);
        const Answer answer = process.wait();
        CHECK(answer.code == 128 + signal);
        if (signal == SIGINT) CHECK(json::parse(answer.out)["complete"] == false);
        CHECK_FALSE(failure_of(planted("exit code"), json::parse(read_text(output))).empty());
    }
    const Answer rest = run_tumble(shrink_arguments(slow, scene, folder / "out"));
    REQUIRE_MESSAGE(rest.code == 0, rest.err);
    CHECK(json::parse(rest.out)["new_runs"] < json::parse(rest.out)["runs"]);
    CHECK(json::parse(read_text(output))["bodies"].size() == 2);
}

TEST_CASE("copies are made fewer, or single, and a run ends where it fails") {
    const Folder folder;
    // The stone hits copy 5, and below it nothing. The claim on all copies needs them repeated, that on one does not.
    for (const std::string copies : {"crate", "crate[5]"}) {
        CAPTURE(copies);
        const std::string scene = folder.write("scene.json", R"({"format": 1, "world": {"duration": 4.3}, "bodies": [
          {"name": "crate", "position": [-12, 5], "gravity_scale": 0,
           "repeat": {"grid": {"columns": 10, "spacing": [3, 0]}},
           "shapes": [{"box": {"size": [1, 1]}}, {"circle": {"radius": 0.3, "center": [5, 40]}}]},
          {"name": "stone", "position": [3.217, 0], "velocity": [0, 11.217], "gravity_scale": 0,
           "shapes": [{"circle": {"radius": 0.5}}]}],
          "expect": [{"body": "stone", "never_touches": ")" + copies +
                                                                 R"("}]})");
        const Answer answer = run_tumble({"shrink", scene, "-o", (folder / "min.json").string(), "--json", "--force"});
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        const json report = json::parse(answer.out), minimal = json::parse(read_text(folder / "min.json"));
        CHECK(report["before"]["bodies"] == 11);
        CHECK(report["after"]["bodies"] == (copies == "crate" ? 7 : 2));
        CHECK(minimal["bodies"][0]["shapes"].size() == 1);
        // 4 m at 11.217 m/s are 0.357 s; rounding may move both by half a metre, and the speed to 11 m/s.
        CHECK(minimal["world"]["duration"] >= 0.3);
        CHECK(minimal["world"]["duration"] <= 0.43);
    }
}

TEST_CASE("bodies to keep stay, and another claim can be chosen") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", R"({"format": 1, "bodies": [
      {"name": "a", "shapes": [{"circle": {"radius": 0.5}}]}, {"name": "b", "shapes": [{"circle": {"radius": 0.5}}]},
      {"name": "c", "shapes": [{"circle": {"radius": 0.5}}]}],
      "expect": [{"body": "a", "height": [5, 6]}, {"body": "b", "height": [-2000, 6]}, {"body": "b", "height": [7, 8]}]})");
    const std::string output = (folder / "min.json").string();
    REQUIRE(run_tumble({"shrink", scene, "-o", output, "--keep", "c", "--claim", "2"}).code == 0);
    const json minimal = json::parse(read_text(output));
    REQUIRE(minimal["bodies"].size() == 2);
    CHECK(minimal["bodies"][0]["name"] == "b");
    CHECK(minimal["bodies"][1]["name"] == "c");
    CHECK(minimal["expect"] == json::array({{{"body", "b"}, {"height", {7, 8}}}}));
    // Other options make another task: its log must not be mixed with this one.
    const Answer other = run_tumble({"shrink", scene, "-o", output});
    CHECK(other.code == 4);
    CHECK(run_tumble({"shrink", scene, "-o", output, "--force"}).code == 0);
    CHECK(json::parse(read_text(output))["bodies"].size() == 1);
    CHECK(run_tumble({"shrink", scene, "-o", output, "--claim", "1", "--force"}).code == 3);
}

TEST_CASE("a run that does not end counts as a failure of its own") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", tumble::test::small_scene());
    const Answer answer = run_tumble({"shrink", scene, "-o", (folder / "min.json").string(), "--timeout", "0.3",
                                      "--fails", "if grep -q ball {}; then sleep 100; fi", "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(json::parse(answer.out)["failure"] == "it takes longer than 0.3 s");
    const json minimal = json::parse(read_text(folder / "min.json"));
    REQUIRE(minimal["bodies"].size() == 1);
    CHECK(minimal["bodies"][0]["name"] == "ball");
}

TEST_CASE("the file of a candidate is one word for the shell, whatever is in its path") {
    const Folder folder;
    const std::string name = "a b; touch $(echo x) 'q'";
    fs::create_directory(folder / name);
    const std::string scene = folder.write(name + "/s c.json", tumble::test::small_scene());
    const Answer answer =
        tumble::test::run({"/usr/bin/env", "TMPDIR=" + (folder / name).string(), TUMBLE_BINARY, "shrink", scene, "-o",
                           (folder / name / "min.json").string(), "--fails", "! grep -q ball {}"},
                          folder.path());
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(json::parse(read_text(folder / name / "min.json"))["bodies"].size() == 1);
    CHECK_FALSE(fs::exists(folder / "x"));
}

TEST_CASE("what cannot be shrunk is refused, and nothing is written") {
    const Folder folder;
    const std::string good = folder.write("good.json", tumble::test::small_scene());
    const std::string hash =
        folder.write("hash.json", R"({"format": 1, "bodies": [], "expect": [{"state_hash": "0123456789abcdef"}]})");
    const std::string bad = folder.write("bad.json", R"({"format": 1, "bodys": []})");
    const std::string output = (folder / "min.json").string();
    const auto refuse = [&](const std::vector<std::string>& arguments, int code, const std::string& message) {
        std::vector<std::string> whole = {"shrink"};
        whole.insert(whole.end(), arguments.begin(), arguments.end());
        const Answer answer = run_tumble(whole);
        CAPTURE(message);
        CHECK(answer.code == code);
        CHECK_MESSAGE(answer.err.find(message) != std::string::npos, answer.err);
        CHECK_FALSE(fs::exists(output));
        CHECK_FALSE(fs::exists(folder / "min.shrink.log"));
    };
    refuse({good, "-o", output}, 3, "good.json: the scene does not fail: it was simulated to its end");
    refuse({hash, "-o", output}, 3, "the scene does not fail");
    refuse({good, "-o", output, "--fails", "true {}"}, 3, "'true {}', which ended with exit code 0");
    refuse({bad, "-o", output}, 3, "bodies");
    refuse({(folder / "gone.json").string(), "-o", output}, 4, "gone.json");
    refuse({good}, 2, "--output");
    refuse({good, "-o", "-"}, 2, "--output");
    refuse({good, "-o", output, "--fails", "false"}, 2, "{}");
    refuse({good, "-o", output, "--fails", "no_such_program_x {}"}, 2, "exit code 127");
    refuse({good, "-o", output, "--same-output"}, 2, "--same-output");
    refuse({good, "-o", output, "--fails", "false {}", "--claim", "0"}, 2, "--claim");
    refuse({good, "-o", output, "--claim", "99"}, 2, "there is no claim /expect/99");
    refuse({good, "-o", output, "--keep", "nobody"}, 2, "nobody");
    refuse({good, "-o", output, "--timeout", "0"}, 2, "--timeout");
    const Answer taken = run_tumble({"shrink", good, "-o", good, "--fails", "false {}"});
    CHECK(taken.code == 4);
    CHECK(read_text(good) == tumble::test::small_scene());
}
