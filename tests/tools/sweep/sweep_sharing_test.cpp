// tumble sweep: threads, processes and folders share the work, and the bytes do not depend on it.
#include <doctest/doctest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "tools/sweep/sweeps.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::are_equal;
using tumble::test::flip_byte;
using tumble::test::Process;
using tumble::test::read_text;
using tumble::test::run_tumble;
using tumble::test::Sweeps;
using tumble::test::tumble_command;

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

TEST_CASE("the lease of an unknown process is taken over after its term") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("whole").code == 0);
    for (const char* lease : {"", "another-system 1 1\n"}) {
        fs::create_directories(sweeps.folder / "out/leases");
        sweeps.folder.write("out/leases/shard-000004", lease);
        const Answer answer = sweeps.sweep("out", {"--lease", "0.3"});
        CHECK_MESSAGE(answer.code == 0, answer.err);
        CHECK(are_equal(sweeps.folder / "whole", sweeps.folder / "out"));
        fs::remove_all(sweeps.folder / "out");
    }
}

TEST_CASE("the lease of a process that has ended is taken over long before its term") {
    const Sweeps sweeps(R"({"format": 1, "scene": "scene.json", "runs": 8000, "shard_runs": 8000})");
    const std::vector<std::string> arguments = sweeps.arguments("out", {"-j", "1", "--lease", "3600"});
    Process killed(tumble_command(arguments));
    tumble::test::wait_for(sweeps.folder / "out/leases/shard-000000", killed);
    killed.send_signal(SIGKILL);
    REQUIRE(killed.wait().code == 128 + SIGKILL);
    REQUIRE(fs::exists(sweeps.folder / "out/leases/shard-000000"));
    const auto start = std::chrono::steady_clock::now();
    CHECK(run_tumble(arguments).code == 0);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::minutes(30));
}

TEST_CASE("a process that is stopped beyond the term of its lease, and the one that takes over, lose no shard") {
    Sweeps sweeps(R"({"format": 1, "scene": "scene.json", "runs": 8000, "shard_runs": 8000})");
    const auto lease = [&] { return sweeps.arguments("out", {"-j", "1", "--lease", "0.2"}); };
    Process stopped(tumble_command(lease()));
    tumble::test::wait_for(sweeps.folder / "out/leases/shard-000000", stopped);
    stopped.send_signal(SIGSTOP);
    Process other(tumble_command(lease()));
    bool is_taken_over = false;
    for (int i = 0; i < 1200 && !is_taken_over; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(25));
        is_taken_over =
            read_text(sweeps.folder / "out/leases/shard-000000").find(std::to_string(other.id())) != std::string::npos;
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

TEST_CASE("merge refuses the lines of a complete part that are not those of its manifest") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("part").code == 0);
    const auto size = static_cast<std::streamoff>(fs::file_size(sweeps.folder / "part/runs.csv"));
    flip_byte(sweeps.folder / "part/runs.csv", size - 5);
    const Answer answer = run_tumble({"sweep", "merge", sweeps.at("whole"), sweeps.at("part")});
    CHECK(answer.code == 3);
    CHECK(answer.err.find(sweeps.at("part/runs.csv") + ": the checksum") != std::string::npos);
    CHECK_FALSE(fs::exists(sweeps.folder / "whole/shard-000019.csv"));
}

TEST_CASE("merge refuses a damaged copy of a scene of a complete part") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("part", {"--runs", "20"}).code == 0);
    flip_byte(sweeps.folder / "part/plan/scene.json", 1);
    const Answer answer = run_tumble({"sweep", "merge", sweeps.at("whole"), sweeps.at("part")});
    CHECK(answer.code == 3);
    CHECK(answer.err.find(sweeps.at("part/plan/scene.json") + ": the checksum") != std::string::npos);
    CHECK_FALSE(fs::exists(sweeps.folder / "whole/plan/scene.json"));
}

TEST_CASE("merge refuses a part without the copy of its scene, unless the whole has it") {
    const Sweeps sweeps;
    REQUIRE(sweeps.sweep("part", {"--runs", "20"}).code == 0);
    REQUIRE(run_tumble({"sweep", "merge", sweeps.at("whole"), sweeps.at("part")}).code == 0);
    fs::remove(sweeps.folder / "part/plan/scene.json");
    CHECK(run_tumble({"sweep", "merge", sweeps.at("whole"), sweeps.at("part")}).code == 0);
    const Answer answer = run_tumble({"sweep", "merge", sweeps.at("other"), sweeps.at("part")});
    CHECK(answer.code == 4);
    CHECK_MESSAGE(answer.err.find(sweeps.at("part/plan/scene.json") + ": is missing") != std::string::npos, answer.err);
}
