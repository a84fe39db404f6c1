// tumble sweep verify: damage is found.
#include <doctest/doctest.h>

#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "tools/sweep/sweeps.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::are_equal;
using tumble::test::flip_byte;
using tumble::test::read_text;
using tumble::test::run_tumble;
using tumble::test::Sweeps;

TEST_CASE("verify reads a table with quotes and words of outcomes in its cells") {
    const Sweeps sweeps(R"({"format": 1, "scene": "scene.json", "shard_runs": 2, "parameters": [
        {"name": "word", "set": "/description", "list": ["timed_out", "a\nb", "c,d", "e \"f\""]}]})");
    REQUIRE(sweeps.sweep("out").code == 0);
    const Answer answer = run_tumble({"sweep", "verify", sweeps.at("out"), sweeps.plan, "--part", "1"});
    CHECK_MESSAGE(answer.code == 0, answer.out);
    CHECK(answer.out.find("4 runs made again, drawn by --seed ") != std::string::npos);
}

TEST_CASE("verify finds a flipped byte in any file, and a sweep replaces a file that was removed") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("out").code == 0);
    REQUIRE(sweeps.sweep("whole").code == 0);
    const Answer sound = run_tumble({"sweep", "verify", sweeps.at("out"), "--part", "0.1", "--json"});
    CHECK_MESSAGE(sound.code == 0, sound.out);
    CHECK(json::parse(sound.out)["repeated_runs"] == 20);
    CHECK(json::parse(sound.out)["files"] == 43);
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

TEST_CASE("a shard that is a device is damage, which --check mends") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("out", {"--runs", "20"}).code == 0);
    REQUIRE(sweeps.sweep("whole", {"--runs", "20"}).code == 0);
    const fs::path shard = sweeps.folder / "out/shard-000001.tar";
    fs::remove(shard);
    fs::create_symlink("/dev/null", shard);
    const Answer damaged = run_tumble({"sweep", "verify", sweeps.at("out")});
    CHECK(damaged.code == 7);
    CHECK_MESSAGE(damaged.out.find("shard-000001.tar: is missing, or no regular file") != std::string::npos,
                  damaged.out);
    CHECK(sweeps.sweep("out", {"--runs", "20", "--check"}).code == 0);
    CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / "out"));
}

TEST_CASE("verify refuses a manifest whose shards have another size than those of the plan") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("out", {"--runs", "20"}).code == 0);
    std::string manifest = read_text(sweeps.folder / "out/manifest.jsonl");
    const std::size_t at = manifest.find("\"shard_runs\":10,");
    REQUIRE(at != std::string::npos);
    sweeps.folder.write("out/manifest.jsonl", manifest.replace(at, 16, "\"shard_runs\":15,"));
    const Answer answer = run_tumble({"sweep", "verify", sweeps.at("out"), "--part", "1"});
    CHECK(answer.code == 4);
    CHECK_MESSAGE(answer.err.find("is of another plan") != std::string::npos, answer.err);
}

TEST_CASE("the path of the plan may have any form: the folder is the same, and nothing is written beside it") {
    const Sweeps sweeps(R"({"format": 1, "scene": "scene.json", "runs": 4,
      "parameters": [{"name": "part", "set": "/include/0/file", "list": ["a.json", "missing.json"]}]})");
    sweeps.folder.write("scene.json", R"({"format": 1, "include": [{"file": "a.json"}]})");
    sweeps.folder.write("a.json", R"({"format": 1})");
    fs::create_directories(sweeps.folder / "other");
    REQUIRE(sweeps.sweep("plain").code == 0);
    CHECK(read_text(sweeps.folder / "plain/runs.csv").find(sweeps.folder.path().string()) == std::string::npos);
    const Answer answer = run_tumble({"sweep", sweeps.at("other/../plan.json"), "-o", sweeps.at("other/out")});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(are_equal(sweeps.folder / "plain", sweeps.folder / "other/out"));
    CHECK(std::distance(fs::directory_iterator(sweeps.folder / "other"), fs::directory_iterator()) == 1);
}

TEST_CASE("what a link in the place of the copies names is neither searched nor changed") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("out", {"--runs", "20"}).code == 0);
    fs::create_directories(sweeps.folder / "private");
    sweeps.folder.write("private/secret", "secret");
    const std::string left = sweeps.folder.write("private/x.2000000000-1.partial", "left");  // of no process
    fs::remove_all(sweeps.folder / "out/plan");
    fs::create_directory_symlink(sweeps.folder / "private", sweeps.folder / "out/plan");
    CHECK(run_tumble({"sweep", "merge", sweeps.at("merged"), sweeps.at("out")}).code == 4);
    CHECK_FALSE(fs::exists(sweeps.folder / "merged/plan"));
    CHECK(run_tumble({"sweep", "merge", sweeps.at("out")}).code == 0);  // completes the folder again
    CHECK(fs::exists(left));
    // The manifest has another checksum of plan/scene.json, and the copy of the plan is missing.
    sweeps.folder.write("private/scene.json", "mine");
    const Answer answer = sweeps.sweep("out", {"--runs", "20", "--check"});
    CHECK(answer.code == 4);
    CHECK_MESSAGE(answer.err.find("plan.json: is reached through a link") != std::string::npos, answer.err);
    CHECK(read_text(sweeps.folder / "private/scene.json") == "mine");
    CHECK_FALSE(fs::exists(sweeps.folder / "private/plan.json"));
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

TEST_CASE("verify needs the folder alone, and draws other runs each time unless the seed is stated") {
    const Sweeps sweeps(R"({"format": 1, "scene": "part/scene.json", "runs": 40,
      "parameters": [{"name": "at", "set": "/include/0/position", "choice": [[0, 0], [1, 2], [3, 4]]}]})");
    fs::create_directories(sweeps.folder / "part");
    sweeps.folder.write("part/scene.json", R"({"format": 1, "include": [{"file": "ball.json"}]})");
    sweeps.folder.write("part/ball.json", R"({"format": 1, "bodies": [{"shapes": [{"circle": {"radius": 1}}]}]})");
    REQUIRE(sweeps.sweep("out").code == 0);
    CHECK(read_text(sweeps.folder / "out/plan/part/ball.json") == read_text(sweeps.folder / "part/ball.json"));
    fs::rename(sweeps.folder / "part", sweeps.folder / "gone");
    fs::remove(sweeps.plan);
    const auto verify = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all{"sweep", "verify", sweeps.at("out"), "--part", "0.5", "--json"};
        all.insert(all.end(), more.begin(), more.end());
        const Answer answer = run_tumble(all);
        CHECK_MESSAGE(answer.code == 0, answer.err);
        return json::parse(answer.out);
    };
    const json first = verify({}), second = verify({});
    CHECK(first["repeated_runs"] == 20);
    CHECK(first["seed"] != second["seed"]);
    CHECK(verify({"--seed", "17"})["seed"] == 17);
    sweeps.folder.write("out/plan/part/ball.json",
                        R"({"format": 1, "bodies": [{"shapes": [{"circle": {"radius": 2}}]}]})");
    const Answer damaged = run_tumble({"sweep", "verify", sweeps.at("out")});
    CHECK(damaged.code == 7);
    CHECK_MESSAGE(damaged.out.find("plan/part/ball.json: its checksum") != std::string::npos, damaged.out);
}

TEST_CASE("verify finds damaged copies of the plan and its scenes, and --check makes them again") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("out", {"--runs", "20"}).code == 0);
    REQUIRE(sweeps.sweep("whole", {"--runs", "20"}).code == 0);
    for (const char* name : {"plan/plan.json", "plan/scene.json"}) {
        const fs::path copy = sweeps.folder / "out" / name;
        flip_byte(copy, 1);
        const Answer damaged = run_tumble({"sweep", "verify", sweeps.at("out")});
        CHECK(damaged.code == 7);
        CHECK_MESSAGE(damaged.out.find(std::string(name) + ": its checksum") != std::string::npos, damaged.out);
        // Completing the folder again keeps the checksum.
        CHECK(run_tumble({"sweep", "merge", sweeps.at("out")}).code == 0);
        CHECK(run_tumble({"sweep", "verify", sweeps.at("out")}).code == 7);
        CHECK(sweeps.sweep("out", {"--runs", "20", "--check"}).code == 0);
        CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / "out"));
        fs::remove(copy);
        CHECK(sweeps.sweep("out", {"--runs", "20"}).code == 0);
        CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / "out"));
    }
}

TEST_CASE("files beside the copies of a sweep are not of it: no checksum, no merge, no fault when they are gone") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("part", {"--runs", "20", "--shard", "0/2"}).code == 0);
    REQUIRE(sweeps.sweep("whole", {"--runs", "20"}).code == 0);
    sweeps.folder.write("part/plan/notes.txt", "mine");
    REQUIRE(run_tumble({"sweep", "merge", sweeps.at("merged"), sweeps.at("part")}).code == 7);  // half of the shards
    CHECK_FALSE(fs::exists(sweeps.folder / "merged/plan/notes.txt"));
    CHECK(fs::exists(sweeps.folder / "merged/plan/scene.json"));
    REQUIRE(sweeps.sweep("part", {"--runs", "20"}).code == 0);
    CHECK(read_text(sweeps.folder / "part/manifest.jsonl") == read_text(sweeps.folder / "whole/manifest.jsonl"));
    fs::remove(sweeps.folder / "part/plan/notes.txt");
    CHECK(run_tumble({"sweep", "verify", sweeps.at("part")}).code == 0);
    CHECK(sweeps.sweep("part", {"--runs", "20"}).code == 0);
}

TEST_CASE("a complete sweep without the first line of its manifest is refused with a remedy, which works") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("out", {"--runs", "20"}).code == 0);
    REQUIRE(sweeps.sweep("whole", {"--runs", "20"}).code == 0);
    fs::resize_file(sweeps.folder / "out/manifest.jsonl", 50);
    const Answer refused = sweeps.sweep("out", {"--runs", "20"});
    CHECK(refused.code == 4);
    CHECK_MESSAGE(refused.err.find("the first line is damaged; remove runs.csv") != std::string::npos, refused.err);
    fs::remove(sweeps.folder / "out/runs.csv");
    CHECK(sweeps.sweep("out", {"--runs", "20"}).code == 0);
    CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / "out"));
}

TEST_CASE("a scene that changes while a sweep is interrupted ends it") {
    const Sweeps sweeps(R"({"format": 1, "scene": "outer.json", "runs": 4, "shard_runs": 1,
      "parameters": [{"name": "part", "set": "/include/0/file", "list": ["a.json", "b.json"]}]})");
    sweeps.folder.write("outer.json", R"({"format": 1, "include": [{"file": "a.json"}]})");
    sweeps.folder.write("a.json", R"({"format": 1})");
    sweeps.folder.write("b.json", R"({"format": 1})");
    REQUIRE(sweeps.sweep("out", {"--shard", "1/4"}).code == 0);
    sweeps.folder.write("b.json", R"({"format": 1, "name": "other"})");  // not of the first run
    const Answer answer = sweeps.sweep("out");
    CHECK(answer.code == 4);
    CHECK_MESSAGE(answer.err.find("b.json: has changed since the sweep began") != std::string::npos, answer.err);
}
