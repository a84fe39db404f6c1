// tumble sweep: the files that it writes, and what it says of them.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/sweep/sweeps.hpp"
#include "tumble/render.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::files_of;
using tumble::test::read_text;
using tumble::test::row;
using tumble::test::run_tumble;
using tumble::test::Sweeps;
using tumble::test::tumble_command;

TEST_CASE("a sweep writes a table, tar files and HDF5 files, and says what it did") {
    const Sweeps sweeps;
    const Answer answer = sweeps.sweep("out", {"--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json report = json::parse(answer.out);
    CHECK(report["runs"] == 200);
    CHECK(report["shards"] == 20);
    CHECK(report["complete"] == true);
    CHECK(report["outcomes"]["ok"] == 200);
    const auto files = files_of(sweeps.folder / "out");
    CHECK(files.size() == 2 * 20 + 2 + 3);
    CHECK(files.at("plan/scene.json") == read_text(sweeps.folder / "scene.json"));
    CHECK(row(sweeps.folder / "out", 0) ==
          std::vector<std::string>{"run", "scene", "seed", "height", "speed", "outcome", "steps", "claims",
                                   "failed_claims", "x", "double_speed", "state_hash", "data_hash", "message"});
    const std::vector<std::string> cells = row(sweeps.folder / "out", 3);
    CHECK(cells[0] == "2");
    CHECK(cells[1] == "scene.json");
    CHECK(cells[4] == "1");   // 2 mod 3 in [-1, 0, 1]
    CHECK(cells[6] == "30");  // 0.5 s
    CHECK(cells[10] == "2");
    CHECK(files.at("shard-000019.h5").starts_with("\x89HDF"));
    // tar(1) reads the archives, and the members have no time.
    const Answer list = tumble::test::run({"/bin/tar", "-tvf", sweeps.at("out/shard-000001.tar"), "--utc"});
    CHECK(list.code == 0);
    CHECK(list.out.find("1970-01-01 00:00 000000000010.json\n") != std::string::npos);
    CHECK(list.out.find("000000000019.events.csv\n") != std::string::npos);
}

TEST_CASE("run --set and --seed make the same run") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("out", {"--runs", "7"}).code == 0);
    const std::vector<std::string> cells = row(sweeps.folder / "out", 6);
    const Answer answer =
        run_tumble({"run", sweeps.at("scene.json"), "--no-frames", "-o", sweeps.at("one"), "--json", "--seed", cells[2],
                    "--set", "/bodies/ball/position/1=" + cells[3], "--set", "/bodies/ball/velocity/0=" + cells[4]});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(json::parse(answer.out)["state_hash"] == cells[11]);
}

TEST_CASE("runs that take too long, are not valid or are filtered are recorded with their seeds") {
    const Sweeps sweeps(R"({"format": 1, "scene": "scene.json", "shard_runs": 2, "timeout": 0.5, "seeds": [7],
      "parameters": [{"name": "duration", "set": "/world/duration", "list": [1, 900000]},
                     {"name": "radius", "set": "/bodies/ball/shapes/0/circle/radius", "list": [0.5, -1]},
                     {"name": "height", "set": "/bodies/ball/position/1", "list": [2, -5]}],
      "filter": {"claims": true, "that": "ball.y > 0"}, "write": {"trajectory": {"as": "npy"}, "final_state": true}})");
    const Answer answer = sweeps.sweep("out", {"--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json outcomes = json::parse(answer.out)["outcomes"];
    // Durations 1 and long, radii valid and not, heights above and below the floor.
    CHECK(outcomes == json{{"ok", 1}, {"filtered", 1}, {"invalid", 4}, {"timed_out", 2}});
    const std::vector<std::string> late = row(sweeps.folder / "out", 5);
    CHECK(late[2] == "7");
    CHECK(late[6] == "timed_out");
    CHECK(late[7].empty());
    const std::vector<std::string> invalid = row(sweeps.folder / "out", 3);
    CHECK(invalid[6] == "invalid");
    CHECK(read_text(sweeps.folder / "out/runs.csv").find("\"must be greater than 0, got -1\"") != std::string::npos);
    const Answer list = tumble::test::run({"/bin/tar", "-tf", sweeps.at("out/shard-000000.tar")});
    CHECK(list.out == "000000000000.state\n000000000000.trajectory.npy\n");  // not of the filtered run
    CHECK(run_tumble({"sweep", "verify", sweeps.at("out"), sweeps.plan, "--part", "1"}).code == 0);
}

TEST_CASE("a run that diverges is recorded with its seed, and keeps its data up to then") {
    // A mote of 1e-30 kg gets an impulse of 1e12 N s after 0.2 s in the second run, and none in the first.
    const Sweeps sweeps(
        R"({"format": 1, "scene": "mote.json", "shard_runs": 1, "seeds": [7], "write": {"trajectory": {"as": "npy"}},
      "parameters": [{"name": "impulse", "set": "/timeline/0/impulse/0", "list": [0, 1e12]}]})");
    sweeps.folder.write("mote.json", R"({"format": 1, "world": {"duration": 1}, "bodies": [{"name": "mote",
      "mass": {"mass": 1e-30, "inertia": 0}, "shapes": [{"circle": {"radius": 0.1}}]}],
      "timeline": [{"at": 0.2, "body": "mote", "impulse": [0, 0]}]})");
    const Answer answer = sweeps.sweep("out", {"--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(json::parse(answer.out)["outcomes"] == json{{"ok", 1}, {"diverged", 1}});
    const std::vector<std::string> cells = row(sweeps.folder / "out", 2);
    CHECK(cells[2] == "7");
    CHECK(cells[4] == "diverged");
    CHECK(cells[5] == "12");  // 0.2 s
    CHECK(cells.back().find("mote") != std::string::npos);
    CHECK(cells[8].empty());  // no state at the end
    const Answer list = tumble::test::run({"/bin/tar", "-tf", sweeps.at("out/shard-000001.tar")});
    CHECK(list.out == "000000000001.trajectory.npy\n");
    CHECK(run_tumble({"sweep", "verify", sweeps.at("out"), "--part", "1"}).code == 0);
}

TEST_CASE("a run that finds no memory is recorded, and the sweep goes on") {
    // A sanitizer needs more memory than the limit below.
    if (std::string(TUMBLE_CXX_FLAGS).find("sanitize") != std::string::npos) return;
    const Sweeps sweeps(R"({"format": 1, "scene": "scene.json", "seeds": [7], "parameters": [
      {"name": "columns", "set": "/bodies/ball/repeat", "list": [{"grid": {"columns": 2, "rows": 1, "spacing": [2, 2]}},
                                                                 {"grid": {"columns": 900, "rows": 900, "spacing": [2, 2]}},
                                                                 {"grid": {"columns": 3, "rows": 1, "spacing": [2, 2]}}]}]})");
    sweeps.folder.write("scene.json", R"({"format": 1, "world": {"duration": 0.1}, "bodies": [
      {"name": "ball", "position": [0, 2], "shapes": [{"circle": {"radius": 0.5}}]}]})");
    std::string command = "ulimit -v 400000; exec";
    for (const std::string& word : tumble_command(sweeps.arguments("out", {"-j", "1", "--json"})))
        command += " '" + word + "'";
    const Answer answer = tumble::test::run({"/bin/sh", "-c", command});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(json::parse(answer.out)["outcomes"] == json{{"ok", 2}, {"failed", 1}});
    CHECK(read_text(sweeps.folder / "out/runs.csv").find(",failed,,0,0,,") != std::string::npos);
    CHECK(read_text(sweeps.folder / "out/runs.csv").find("no memory") != std::string::npos);
}

TEST_CASE("the default shard makes a sweep of 100 000 runs at most 200 files, while it runs and at its end") {
    const Sweeps sweeps(R"({"format": 1, "scene": "scene.json", "runs": 100000,
      "write": {"trajectory": {"every": 10}, "summary": true}})");
    const json estimate = json::parse(run_tumble({"sweep", sweeps.plan, "--dry-run", "--json"}).out);
    CHECK(estimate["shards"] == 60);
    CHECK(estimate["shard_runs"] == 1667);
    // A tar file, an HDF5 file and the lines of each shard; the manifest, the table, the plan and its scene.
    CHECK(estimate["shards"].get<int>() * 3 + 4 <= 200);
    CHECK(estimate["files"] == 60 * 2 + 4);
}

TEST_CASE("a dry run tells the cost of 10^12 runs from a sample of 20, and writes nothing") {
    const Sweeps sweeps;
    const Answer answer = run_tumble({"sweep", sweeps.plan, "--dry-run", "--json", "--runs", "1000000000000"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json estimate = json::parse(answer.out);
    CHECK(estimate["runs"] == 1000000000000);
    CHECK(estimate["sampled"] == 20);
    CHECK(estimate["shards"] == 100000000000);
    CHECK(estimate["bytes"] > 1e14);
    CHECK(sweeps.sweep("out", {"--runs", "1000000000000"}).code == 3);
    CHECK_FALSE(fs::exists(sweeps.folder / "out"));
}

TEST_CASE("a dry run tells why the first run of its sample has no end state") {
    const Sweeps sweeps(R"({"format": 1, "scene": "scene.json",
      "parameters": [{"name": "m", "set": "/bodies/ball/shapes/0/circle/radius", "list": [0.5, -1]}]})");
    const Answer answer = run_tumble({"sweep", sweeps.plan, "--dry-run"});
    CHECK(answer.code == 0);
    CHECK_MESSAGE(answer.out.ends_with(": 1 invalid, 1 ok\n  run 1 (invalid): must be greater than 0, got -1\n"),
                  answer.out);
    const json estimate = json::parse(run_tumble({"sweep", sweeps.plan, "--dry-run", "--json"}).out);
    CHECK(estimate["failure"] == "run 1 (invalid): must be greater than 0, got -1");
}

TEST_CASE("status tells what is missing") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("out", {"--shard", "1/4"}).code == 0);
    const json status = json::parse(run_tumble({"sweep", "status", sweeps.at("out"), "--json"}).out);
    CHECK(status["stored_shards"] == 5);
    CHECK(status["complete"] == false);
    CHECK(status["missing"] == json::parse("[[0, 0], [2, 4], [6, 8], [10, 12], [14, 16], [18, 19]]"));
}

TEST_CASE("plot draws a heat map of the grid, and dots without a second axis") {
    const Sweeps sweeps(R"({"format": 1, "scene": "scene.json",
      "parameters": [{"name": "a", "list": [0, 1, 2]}, {"name": "b", "range": [0, 3], "count": 4}],
      "measures": [{"name": "product", "value": "a * b"}]})");
    REQUIRE(sweeps.sweep("out").code == 0);
    const auto plot = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all{"sweep", "plot", sweeps.at("out"), "--x", "a", "-o", "-"};
        all.insert(all.end(), more.begin(), more.end());
        return run_tumble(all);
    };
    const Answer map = plot({"--y", "b", "--value", "product"});
    REQUIRE_MESSAGE(map.code == 0, map.err);
    const auto count = [](const std::string& text, const std::string& word) {
        int found = 0;
        for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
        return found;
    };
    // 0 is dark blue: all of a = 0 and of b = 0, 3 + 4 - 1 of 12 cells. 2 * 3 is yellow: one.
    CHECK(count(map.out, "#440154") == 6);
    CHECK(count(map.out, "#fde725") == 1);
    CHECK(count(plot({"--value", "product"}).out, "<circle") == 12);
    CHECK(count(plot({"--value", "product"}).out, " r=\"4\"") == 12);
    const Answer misspelt = plot({"--value", "produkt"});
    CHECK(misspelt.code == 3);
    CHECK(misspelt.err.find("runs.csv: has no column 'produkt'; did you mean 'product'?\n  its columns: run, ") !=
          std::string::npos);
    CHECK(plot({"--value", "message"}).code == 3);
    const auto written = [&](const std::string& name) {
        return run_tumble({"sweep", "plot", sweeps.at("out"), "--x", "a", "--value", "product", "-o", sweeps.at(name)});
    };
    REQUIRE(written("plot.png").code == 0);
    CHECK(tumble::read_png(sweeps.at("plot.png")).width == 590);
    CHECK(written("plot.jpg").code == 2);
    CHECK(written("plot.jpg").err.find("--output: expected a file name that ends in .svg or .png") !=
          std::string::npos);
    CHECK(run_tumble({"sweep", "plot", sweeps.at("gone"), "--x", "a", "--value", "b", "-o", "-"}).code == 4);
}
