// tumble sweep submit: the scripts of job arrays.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/sweep/sweeps.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::run_tumble;
using tumble::test::Sweeps;

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
    const std::vector<std::string> slash{"sweep",   "submit", sweeps.plan, "-o", sweeps.at("out") + "/",
                                         "--slurm", "--print"};
    CHECK(run_tumble(slash).out.find("#SBATCH --output=" + sweeps.at("out") + ".slurm/") != std::string::npos);
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
