// tumble sweep: nothing is lost, nothing depends on who did the work, and damage is found.
#include <doctest/doctest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "process.hpp"
#include "support/small_disk.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::Process;
using tumble::test::read_text;
using tumble::test::run_tumble;
using tumble::test::tumble_command;

namespace {

constexpr const char* kScene = R"({"format": 1, "world": {"duration": 0.5},
  "bodies": [{"name": "floor", "type": "static", "shapes": [{"box": {"size": [20, 1]}}]},
             {"name": "ball", "position": [0, 2], "velocity": [0, 0], "shapes": [{"circle": {"radius": 0.5}}]}],
  "expect": [{"that": "ball.y > 0.9"}]})";

constexpr const char* kPlan = R"({"format": 1, "scene": "scene.json", "runs": 200, "shard_runs": 10,
  "parameters": [{"name": "height", "set": "/bodies/ball/position/1", "range": [1.2, 4]},
                 {"name": "speed", "set": ["/bodies/ball/velocity/0"], "list": [-1, 0, 1]}],
  "measures": [{"name": "x", "value": "ball.x"}, {"name": "double_speed", "value": "2 * speed"}],
  "write": {"trajectory": {"every": 5}, "events": true, "summary": true}})";

// A folder with a scene, a plan and the names of results.
struct Sweeps {
    Folder folder;
    std::string plan;

    explicit Sweeps(const std::string& text = kPlan) {
        folder.write("scene.json", kScene);
        plan = folder.write("plan.json", text);
    }
    std::string at(const std::string& name) const { return (folder / name).string(); }
    std::vector<std::string> arguments(const std::string& name, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> all{"sweep", plan, "-o", at(name)};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    Answer sweep(const std::string& name, const std::vector<std::string>& more = {}) const {
        return run_tumble(arguments(name, more));
    }
};

std::map<std::string, std::string> files_of(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        files[fs::relative(entry.path(), folder).string()] = entry.is_directory() ? "folder" : read_text(entry.path());
    return files;
}

bool are_equal(const fs::path& a, const fs::path& b) {
    const auto in_a = files_of(a), in_b = files_of(b);
    for (const auto& [name, bytes] : in_a)
        if (!in_b.contains(name) || in_b.at(name) != bytes) MESSAGE(name << " differs or is missing in the second");
    for (const auto& [name, bytes] : in_b)
        if (!in_a.contains(name)) MESSAGE(name << " is in the second only");
    return in_a == in_b;
}

// The cells of a line of runs.csv.
std::vector<std::string> row(const fs::path& folder, std::size_t line) {
    std::istringstream text(read_text(folder / "runs.csv"));
    std::string found;
    for (std::size_t i = 0; i <= line; ++i) std::getline(text, found);
    std::vector<std::string> cells;
    std::istringstream parts(found);
    for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
    return cells;
}

void flip_byte(const fs::path& file, std::streamoff at) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekg(at);
    const int byte = stream.get();
    stream.seekp(at);
    stream.put(static_cast<char>(byte ^ 1));
}

}  // namespace

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
    CHECK(files.size() == 2 * 20 + 2);
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

TEST_CASE("a sweep that is killed again and again has the bytes of one that was not") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("whole", {"-j", "1", "--runs", "2000"}).code == 0);
    int killed = 0;
    for (int i = 0; i < 20; ++i) {
        Process process(tumble_command(sweeps.arguments("killed", {"-j", "2", "--runs", "2000"})));
        std::this_thread::sleep_for(std::chrono::milliseconds(15 + 11 * (i % 5)));
        process.send_signal(SIGKILL);
        killed += process.wait().code == 128 + SIGKILL ? 1 : 0;
    }
    CHECK(killed > 3);
    const Answer last = sweeps.sweep("killed", {"-j", "2", "--runs", "2000"});
    REQUIRE_MESSAGE(last.code == 0, last.err);
    CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / "killed"));
}

TEST_CASE("a sweep that is interrupted continues, and does only what is missing") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("whole", {"--runs", "3000"}).code == 0);
    Process process(tumble_command(sweeps.arguments("out", {"-j", "1", "--runs", "3000"})));
    tumble::test::wait_for(sweeps.folder / "out/shard-000003.csv", process);
    process.send_signal(SIGTERM);
    const Answer stopped = process.wait();
    CHECK(stopped.code == 143);
    CHECK(stopped.out.find("shards are missing") != std::string::npos);
    const json rest = json::parse(sweeps.sweep("out", {"--json", "--runs", "3000"}).out);
    CHECK(rest["simulated_runs"] <= 3000 - 40);
    CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / "out"));
    CHECK(json::parse(sweeps.sweep("out", {"--json", "--runs", "3000"}).out)["simulated_runs"] == 0);
}

TEST_CASE("the bytes do not depend on how many processes and threads share the work") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("whole", {"-j", "1"}).code == 0);
    for (const int parts : {2, 16}) {
        std::vector<std::string> merge{"sweep", "merge", sweeps.at("merged-" + std::to_string(parts))};
        for (int part = 0; part < parts; ++part) {
            const std::string name = "part-" + std::to_string(part) + "-of-" + std::to_string(parts);
            const std::string share = std::to_string(part) + "/" + std::to_string(parts);
            CHECK(sweeps.sweep(name, {"--shard", share, "-j", std::to_string(1 + part % 3)}).code == 0);
            // Without the last part, shards are missing.
            if (part == parts - 1) CHECK(run_tumble(merge).code == 7);
            merge.push_back(sweeps.at(name));
        }
        const Answer answer = run_tumble(merge);
        CHECK_MESSAGE(answer.code == 0, answer.err);
        CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / ("merged-" + std::to_string(parts))));
    }
}

TEST_CASE("two processes on one folder share its shards") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("whole", {"--runs", "2000"}).code == 0);
    const std::vector<std::string> command =
        tumble_command(sweeps.arguments("shared", {"-j", "1", "--json", "--runs", "2000"}));
    Process one(command), other(command);
    const Answer first = one.wait(), second = other.wait();
    CHECK_MESSAGE(first.code == 0, first.err);
    CHECK_MESSAGE(second.code == 0, second.err);
    const int runs =
        json::parse(first.out)["simulated_runs"].get<int>() + json::parse(second.out)["simulated_runs"].get<int>();
    CHECK(runs == 2000);
    CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / "shared"));
}

TEST_CASE("the claim of a process that has ended is taken over at once, that of an unknown one after its lease") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("whole").code == 0);
    for (const char* claim : {"", "another-system 1 1\n"}) {
        fs::create_directories(sweeps.folder / "out/claims");
        sweeps.folder.write("out/claims/shard-000004", claim);
        const Answer answer = sweeps.sweep("out", {"--lease", "0.3"});
        CHECK_MESSAGE(answer.code == 0, answer.err);
        CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / "out"));
        fs::remove_all(sweeps.folder / "out");
    }
}

TEST_CASE("a process that is stopped beyond its lease, and the one that takes over, lose no shard") {
    Sweeps sweeps(R"({"format": 1, "scene": "scene.json", "runs": 8000, "shard_runs": 8000})");
    const auto lease = [&] { return sweeps.arguments("out", {"-j", "1", "--lease", "0.2"}); };
    Process stopped(tumble_command(lease()));
    tumble::test::wait_for(sweeps.folder / "out/claims/shard-000000", stopped);
    stopped.send_signal(SIGSTOP);
    Process other(tumble_command(lease()));
    bool is_taken_over = false;
    for (int i = 0; i < 200 && !is_taken_over; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(25));
        is_taken_over =
            read_text(sweeps.folder / "out/claims/shard-000000").find(std::to_string(other.id())) != std::string::npos;
    }
    CHECK(is_taken_over);
    stopped.send_signal(SIGCONT);
    CHECK(stopped.wait().code == 0);
    CHECK(other.wait().code == 0);
    const json status = json::parse(run_tumble({"sweep", "status", sweeps.at("out"), "--json"}).out);
    CHECK(status["complete"] == true);
    CHECK(status["stored_shards"] == 1);
    REQUIRE(sweeps.sweep("alone").code == 0);
    CHECK(are_equal(sweeps.folder / "out", sweeps.folder / "alone"));
}

TEST_CASE("a signal ends a dry run and verify with its code") {
    Sweeps sweeps(
        R"({"format": 1, "scene": "scene.json", "runs": 4, "shard_runs": 4, "set": {"/world/duration": 20}})");
    REQUIRE(sweeps.sweep("out").code == 0);
    Sweeps slow(R"({"format": 1, "scene": "scene.json", "runs": 40, "set": {"/world/duration": 3600}})");
    const std::vector<std::vector<std::string>> commands{
        {"sweep", slow.plan, "--dry-run"}, {"sweep", "verify", sweeps.at("out"), sweeps.plan, "--part", "1"}};
    Process dry(tumble_command(commands[0]));
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    dry.send_signal(SIGTERM);
    CHECK(dry.wait().code == 143);
    CHECK(run_tumble(commands[1]).code == 0);
}

TEST_CASE("merge refuses the lines of a complete part that are not those of its manifest") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("part").code == 0);
    const auto size = static_cast<std::streamoff>(fs::file_size(sweeps.folder / "part/runs.csv"));
    flip_byte(sweeps.folder / "part/runs.csv", size - 5);
    const Answer answer = run_tumble({"sweep", "merge", sweeps.at("whole"), sweeps.at("part")});
    CHECK(answer.code != 0);
    CHECK(answer.err.find(sweeps.at("part/runs.csv") + ": the checksum") != std::string::npos);
    CHECK_FALSE(fs::exists(sweeps.folder / "whole/shard-000019.csv"));
}

TEST_CASE("verify reads a table with quotes and words of outcomes in its cells") {
    const Sweeps sweeps(R"({"format": 1, "scene": "scene.json", "shard_runs": 2, "parameters": [
        {"name": "word", "set": "/description", "list": ["timed_out", "a\nb", "c,d", "e \"f\""]}]})");
    REQUIRE(sweeps.sweep("out").code == 0);
    const Answer answer = run_tumble({"sweep", "verify", sweeps.at("out"), sweeps.plan, "--part", "1"});
    CHECK_MESSAGE(answer.code == 0, answer.out);
    CHECK(answer.out.find("4 runs made again: all as written") != std::string::npos);
}

TEST_CASE("a manifest that is cut in the middle loses only what it no longer says") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("whole").code == 0);
    for (const double part : {0.0, 0.02, 0.5, 0.97}) {
        fs::remove_all(sweeps.folder / "cut");
        fs::copy(sweeps.folder / "whole", sweeps.folder / "cut");
        const fs::path manifest = sweeps.folder / "cut/manifest.jsonl";
        fs::resize_file(manifest, static_cast<std::uintmax_t>(part * static_cast<double>(fs::file_size(manifest))));
        if (part < 0.1) fs::remove(sweeps.folder / "cut/runs.csv");  // nothing says any more what it is
        const Answer answer = sweeps.sweep("cut");
        CHECK_MESSAGE(answer.code == 0, answer.err);
        CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / "cut"));
    }
}

TEST_CASE("verify finds a flipped byte in any file, and a sweep replaces a file that was removed") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("out").code == 0);
    REQUIRE(sweeps.sweep("whole").code == 0);
    const Answer sound = run_tumble({"sweep", "verify", sweeps.at("out"), sweeps.plan, "--part", "0.1", "--json"});
    CHECK_MESSAGE(sound.code == 0, sound.out);
    CHECK(json::parse(sound.out)["repeated_runs"] == 20);
    CHECK(json::parse(sound.out)["files"] == 41);
    for (const char* name : {"shard-000007.tar", "shard-000007.h5", "runs.csv"}) {
        const fs::path file = sweeps.folder / "out" / name;
        flip_byte(file, static_cast<std::streamoff>(fs::file_size(file) / 2));
        const Answer damaged = run_tumble({"sweep", "verify", sweeps.at("out")});
        CHECK(damaged.code == 7);
        CHECK_MESSAGE(damaged.out.find(std::string(name) + ": its checksum") != std::string::npos, damaged.out);
        fs::remove(file);
        CHECK(run_tumble({"sweep", "verify", sweeps.at("out")}).out.find("is missing") != std::string::npos);
        CHECK(sweeps.sweep("out").code == 0);
        CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / "out"));
    }
}

TEST_CASE("verify finds a run that is not the one of the table") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("out", {"--runs", "10"}).code == 0);
    std::string table = read_text(sweeps.folder / "out/runs.csv");
    const std::size_t digit = table.find(",ok,30,") + 4;
    table[digit] = '4';
    sweeps.folder.write("out/runs.csv", table);
    const Answer answer = run_tumble({"sweep", "verify", sweeps.at("out"), sweeps.plan, "--part", "1"});
    CHECK(answer.code == 7);
    CHECK_MESSAGE(answer.out.find("run 0: the table has") != std::string::npos, answer.out);
}

TEST_CASE("a full disk ends a sweep with exit code 4, and with more room it continues") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("whole").code == 0);
    {
        const tumble::test::SmallDisk disk(sweeps.folder / "disk", 256);
        if (!disk.is_mounted()) return;
        const Answer answer = sweeps.sweep("disk/out");
        CHECK(answer.code == 4);
        CHECK_MESSAGE(answer.err.find("No space left") != std::string::npos, answer.err);
        fs::copy(sweeps.folder / "disk/out", sweeps.folder / "out", fs::copy_options::recursive);
        for (const auto& [name, bytes] : files_of(sweeps.folder / "out")) CHECK(!name.ends_with(".partial"));
    }
    const json rest = json::parse(sweeps.sweep("out", {"--json"}).out);
    CHECK(rest["simulated_runs"] < 200);
    CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / "out"));
}

TEST_CASE("runs that diverge, take too long, are not valid or are filtered are recorded with their seeds") {
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
    CHECK(plot({"--value", "area"}).code == 3);
    CHECK(plot({"--value", "message"}).code == 3);
    CHECK(run_tumble({"sweep", "plot", sweeps.at("gone"), "--x", "a", "--value", "b", "-o", "-"}).code == 4);
}

TEST_CASE("submit writes a script for Slurm with as many tasks as take a minute") {
    const Sweeps sweeps;
    const Answer answer = run_tumble({"sweep", "submit", sweeps.plan, "-o", sweeps.at("out"), "--slurm", "--print",
                                      "--tasks", "8", "--sbatch", "--partition=main"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(answer.out.starts_with("#!/bin/sh\n"));
    CHECK(answer.out.find("#SBATCH --array=0-7\n") != std::string::npos);
    CHECK(answer.out.find("#SBATCH --partition=main\n") != std::string::npos);
    CHECK(answer.out.find("--shard \"$SLURM_ARRAY_TASK_ID\"/8") != std::string::npos);
    CHECK(run_tumble({"sweep", "submit", sweeps.plan, "-o", sweeps.at("out"), "--print"}).code == 2);
    const Answer printed = run_tumble(
        {"sweep", "submit", sweeps.plan, "-o", sweeps.at("out"), "--slurm", "--print", "--tasks", "100", "--json"});
    CHECK(json::parse(printed.out)["array"] == "0-19");  // a task for each shard
    CHECK(json::parse(printed.out)["script"].get<std::string>().starts_with("#!/bin/sh\n"));
    for (const char* const name : {"a b", "a\nb", "a'b", "a%b"})
        CHECK(run_tumble({"sweep", "submit", sweeps.plan, "-o", sweeps.at(name), "--slurm", "--print"}).code == 2);
    const Answer unknown = run_tumble({"sweep", "verify", sweeps.at("out"), "--prt", "1"});
    CHECK(unknown.code == 2);
    CHECK(unknown.err.find("of verify\n  hint: did you mean '--part'?") != std::string::npos);
    // Two hundred runs of a millisecond are one task.
    CHECK(run_tumble({"sweep", "submit", sweeps.plan, "-o", sweeps.at("out"), "--slurm", "--print"})
              .out.find("--array=0-0\n") != std::string::npos);
    // Only the tasks with missing shards: shard 9 is of task 1 of 8.
    REQUIRE(sweeps.sweep("out").code == 0);
    CHECK(run_tumble({"sweep", "submit", sweeps.plan, "-o", sweeps.at("out"), "--slurm", "--print", "--tasks", "8"})
              .out.find("complete") != std::string::npos);
    fs::remove(sweeps.folder / "out/shard-000009.tar");
    CHECK(run_tumble({"sweep", "submit", sweeps.plan, "-o", sweeps.at("out"), "--slurm", "--print", "--tasks", "8"})
              .out.find("--array=1\n") != std::string::npos);
}
