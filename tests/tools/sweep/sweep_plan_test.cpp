// tumble sweep: errors and warnings of plans, and the plans that are shipped.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tools/sweep/sweeps.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::run_tumble;
using tumble::test::Sweeps;

TEST_CASE("errors of a plan are located in it, and a folder of something else is refused") {
    const Sweeps sweeps;
    const auto answer_of = [&](const std::string& text) {
        return run_tumble({"sweep", sweeps.folder.write("bad.json", text), "--dry-run"});
    };
    const auto check = [&](const std::string& text, const std::string& place, const std::string& message) {
        const Answer answer = answer_of(text);
        CAPTURE(text);
        CHECK(answer.code == 3);
        CHECK_MESSAGE(answer.err.find("bad.json:" + place) != std::string::npos, answer.err);
        CHECK_MESSAGE(answer.err.find(message) != std::string::npos, answer.err);
    };
    check(R"({"format": 1, "scene": "scene.json", "rnus": 3})", "1:38: /rnus", "did you mean 'runs'?");
    check(R"({"format": 1})", "1:1: ", "needs one of the keys scene, scenes");
    check(R"({"format": 1, "bodies": []})", "1:1: ", "hint: this is a scene; a plan names it");
    check(R"({"format": 1, "scene": "scene.json", "write": {"masks": true}})", "1:57: /write/masks", "hint: {} asks");
    check(R"({"format": 1, "scene": "gone.json"})", "1:24: /scene", "gone.json");
    check(
        R"({"format": 1, "scene": "scene.json", "parameters": [{"name": "a", "set": "/bodies/bal/angle", "range": [0, 1]}]})",
        "1:74: /parameters/0/set", "did you mean 'ball'?");
    check(R"({"format": 1, "scene": "scene.json", "parameters": [{"name": "a", "range": [2, 1]}]})",
          "1:76: ", "lower <= upper");
    check(R"({"format": 1, "scene": "scene.json", "measures": [{"name": "a", "value": "1 + bal.y"}]})",
          "1:79: ", "did you mean 'ball'?");
    check(R"({"format": 1, "scene": "scene.json", "filter": {"that": "ball.y"}})", "1:57: ", "must be a condition");
    check(R"({"format": 1, "scene": "scene.json", "parameters": [{"name": "run", "list": [1]}]})", "1:62: ", "column");

    REQUIRE(sweeps.sweep("out", {"--runs", "3"}).code == 0);
    CHECK(sweeps.sweep("out", {"--runs", "4"}).code == 4);
    sweeps.folder.write("notes.txt", "x");
    CHECK(run_tumble({"sweep", sweeps.plan, "-o", sweeps.folder.path().string()}).code == 4);
    CHECK(run_tumble({"sweep", sweeps.plan}).code == 2);
    CHECK(sweeps.sweep("x", {"--shard", "2/2"}).code == 2);
    CHECK(run_tumble({"sweep", "status", sweeps.folder.path().string()}).code == 4);
    CHECK(sweeps.sweep("/proc/sweep").code == 4);
}

TEST_CASE("a plan that is probably not meant so has a warning at its place") {
    const Sweeps sweeps;
    const auto warning_of = [&](const std::string& plan) {
        const Answer answer = run_tumble({"sweep", sweeps.folder.write("odd.json", plan), "--dry-run"});
        CHECK_MESSAGE(answer.code == 0, answer.err);
        return answer.err;
    };
    const auto check = [&](const std::string& plan, const std::string& place, const std::string& message) {
        const std::string warning = warning_of(plan);
        CHECK_MESSAGE(warning.find("odd.json:" + place) != std::string::npos, warning);
        CHECK_MESSAGE(warning.find(message) != std::string::npos, warning);
    };
    const std::string start = R"({"format": 1, "scene": "scene.json", )";
    check(start + R"("runs": 2, "parameters": [{"name": "height", "range": [1, 2]}]})", "1:73: /parameters/0/name",
          "nothing depends on 'height'");
    CHECK(warning_of(start + R"("runs": 2, "parameters": [{"name": "height", "range": [1, 2]}],
                                "measures": [{"name": "m", "value": "2 * height"}]})") == "");
    check(start + R"("runs": 2, "parameters": [{"name": "eight", "range": [1, 2]}],
                     "measures": [{"name": "m", "value": "ball.x + ball.y"}], "filter": {"that": "ball.x < 8"}})",
          "1:73: /parameters/0/name", "nothing depends on 'eight'");
    const std::string grid = R"("parameters": [{"name": "v", "set": "/bodies/ball/velocity/0", "list": [1, 2, 3]}]})";
    check(start + R"("runs": 7, )" + grid, "1:46: /runs", "no multiple of the 3 points");
    CHECK(warning_of(start + R"("runs": 6, )" + grid) == "");
    check(start + R"("set": {"/expect": []}, "filter": {"claims": true}})", "1:83: /filter/claims",
          "no scene has claims");
    const std::string drawn = R"("parameters": [{"name": "v", "set": "/bodies/ball/velocity/0", "range": [1, 3]}]})";
    check(start + drawn, "1:1: ", "one run, with one value of each parameter that is drawn");
    const Answer asked = run_tumble({"sweep", (sweeps.folder / "odd.json").string(), "--dry-run", "--runs", "1"});
    CHECK_MESSAGE(asked.err == "", asked.err);
    CHECK(warning_of(start + R"("runs": 2, )" + drawn) == "");
    CHECK(warning_of(start + R"("runs": 1, )" + drawn) == "");
    const std::string mixed =
        R"("parameters": [{"name": "x", "set": "/bodies/ball/position/0", "list": [1, 2, 3, 4, 5]},
        {"name": "v", "set": "/bodies/ball/velocity/0", "range": [1, 3]}]})";
    check(start + mixed, "1:1: ", "each point of the grid has one run, with one value of each parameter that is drawn");
    CHECK(warning_of(start + R"("runs": 5, )" + mixed) == "");
    check(start + R"("runs": 20, "write": {"masks": {"every": 30}}})", "1:69: /write/masks", "fitted to each run");
    check(start + R"("runs": 100000, "shard_runs": 5})", "1:68: /shard_runs", "the folder will have 20000");
}

TEST_CASE("the shipped plans run") {
    int plans = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(TUMBLE_SOURCE_DIR) / "scenes/plans")) {
        if (!entry.path().string().ends_with(".plan.json")) continue;
        CAPTURE(entry.path());
        const tumble::test::Folder folder;
        const std::string out = (folder / "out").string();
        const Answer answer = run_tumble({"sweep", entry.path().string(), "-o", out, "--runs", "4", "--json"});
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        const json report = json::parse(answer.out);
        CHECK(report["outcomes"].value("ok", 0) + report["outcomes"].value("filtered", 0) == 4);
        CHECK(run_tumble({"sweep", "verify", out}).code == 0);
        ++plans;
    }
    CHECK(plans == 5);
}
