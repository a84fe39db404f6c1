// tumble sweep: after a kill, a signal, a full disk or damage the same command loses nothing.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "support/small_disk.hpp"
#include "tools/sweep/sweeps.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::are_equal;
using tumble::test::files_of;
using tumble::test::flip_byte;
using tumble::test::Process;
using tumble::test::read_text;
using tumble::test::row;
using tumble::test::run_tumble;
using tumble::test::Sweeps;
using tumble::test::tumble_command;

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
    CHECK(stopped.out.find("\nmissing: ") != std::string::npos);
    const json rest = json::parse(sweeps.sweep("out", {"--json", "--runs", "3000"}).out);
    CHECK(rest["simulated_runs"] <= 3000 - 40);
    CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / "out"));
    CHECK(json::parse(sweeps.sweep("out", {"--json", "--runs", "3000"}).out)["simulated_runs"] == 0);
}

TEST_CASE("a signal ends a dry run and verify with its code") {
    // A run takes some 20 ms, so that all of them take much longer than until the signal.
    const Sweeps slow(R"({"format": 1, "scene": "scene.json", "runs": 40, "set": {"/world/duration": 3600}})");
    REQUIRE(slow.sweep("out").code == 0);
    for (const std::vector<std::string>& command : {std::vector<std::string>{"sweep", slow.plan, "--dry-run"},
                                                    {"sweep", "verify", slow.at("out"), "--part", "1"}}) {
        Process process(tumble_command(command));
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        process.send_signal(SIGTERM);
        CHECK(process.wait().code == 143);
    }
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

TEST_CASE("a full disk ends a sweep with exit code 4, and with more room it continues") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("whole").code == 0);
    {
        const tumble::test::SmallDisk disk(sweeps.folder / "disk", 256);
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

TEST_CASE("a read-only disk ends a sweep with exit code 4, and status and verify read it") {
    const Sweeps sweeps;
    const tumble::test::SmallDisk disk(sweeps.folder / "disk", 4096);
    REQUIRE(sweeps.sweep("disk/out", {"--shard", "0/2"}).code == 0);
    disk.make_read_only();
    for (const char* const name : {"disk/out", "disk/new"}) {
        const Answer answer = sweeps.sweep(name);
        CHECK(answer.code == 4);
        CHECK_MESSAGE(answer.err.find("Read-only file system") != std::string::npos, answer.err);
    }
    CHECK(json::parse(run_tumble({"sweep", "status", sweeps.at("disk/out"), "--json"}).out)["stored_shards"] == 10);
    // Three of each shard, and the copies of the plan and of its scene.
    CHECK(json::parse(run_tumble({"sweep", "verify", sweeps.at("disk/out"), "--json"}).out)["files"] == 10 * 3 + 2);
}

TEST_CASE("a byte that changes in a shard while the sweep runs is found, and --check makes the shard again") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("whole").code == 0);
    REQUIRE(sweeps.sweep("out", {"--shard", "0/2"}).code == 0);
    const auto flip_middle = [&](const char* name) {
        const fs::path file = sweeps.folder / "out" / name;
        flip_byte(file, static_cast<std::streamoff>(fs::file_size(file) / 2));
    };
    flip_middle("shard-000004.tar");
    flip_middle("shard-000006.h5");
    // A size tells nothing: the sweep takes both as they are, and verify tells.
    CHECK(sweeps.sweep("out").code == 0);
    CHECK(json::parse(run_tumble({"sweep", "verify", sweeps.at("out"), "--json"}).out)["findings"].size() == 2);
    const json again = json::parse(sweeps.sweep("out", {"--check", "--json"}).out);
    CHECK(again["simulated_runs"] == 20);
    CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / "out"));
}

TEST_CASE("a byte that changes in the lines of a shard ends the sweep before they are in the table") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("out", {"--shard", "0/2"}).code == 0);
    flip_byte(sweeps.folder / "out/shard-000004.csv", 3);
    const Answer answer = sweeps.sweep("out");
    CHECK(answer.code == 3);
    CHECK_MESSAGE(answer.err.find("shard-000004.csv: the checksum") != std::string::npos, answer.err);
    CHECK(answer.err.find("--check") != std::string::npos);
    CHECK(sweeps.sweep("out", {"--check"}).code == 0);
    REQUIRE(sweeps.sweep("whole").code == 0);
    CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / "out"));
}

TEST_CASE("a run that crashes its process twice is recorded, and the sweep goes on") {
    // Run 2 lasts for minutes, so that it is the one that gets the signal.
    const Sweeps sweeps(
        R"({"format": 1, "scene": "scene.json", "shard_runs": 2, "seeds": [7], "write": {"summary": true},
      "parameters": [{"name": "duration", "set": "/world/duration", "list": [1, 1, 900000, 1, 1]}]})");
    const fs::path log = sweeps.folder / "out/leases/crashes";
    const auto crashes = [&] { return fs::exists(log) ? std::ranges::count(read_text(log), '\n') : 0; };
    // A signal that comes before run 2 begins is not recorded: the next sweep waits longer for it.
    for (int i = 1; i <= 10 && crashes() < 2; ++i) {
        // The address sanitizer would take the signal, and end the process with 1, or with 139 if its report fails.
        std::vector<std::string> command{"env", "ASAN_OPTIONS=handle_segv=0"};
        std::ranges::copy(tumble_command(sweeps.arguments("out", {"-j", "1"})), std::back_inserter(command));
        Process process(command);
        tumble::test::wait_for(sweeps.folder / "out/leases/shard-000001", process);
        std::this_thread::sleep_for(std::chrono::milliseconds(200 * i));
        process.send_signal(SIGSEGV);
        CHECK(process.wait().code == 128 + SIGSEGV);
    }
    REQUIRE(read_text(log) == "2 SIGSEGV\n2 SIGSEGV\n");
    const Answer answer = sweeps.sweep("out", {"-j", "1", "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(json::parse(answer.out)["outcomes"] == json{{"ok", 4}, {"crashed", 1}});
    const std::vector<std::string> cells = row(sweeps.folder / "out", 3);
    CHECK(cells[0] == "2");
    CHECK(cells[2] == "7");
    CHECK(cells[4] == "crashed");
    CHECK(read_text(sweeps.folder / "out/runs.csv").find("SIGSEGV") != std::string::npos);
    CHECK_FALSE(fs::exists(sweeps.folder / "out/leases"));
    CHECK(run_tumble({"sweep", "verify", sweeps.at("out"), "--part", "1"}).code == 0);
}
