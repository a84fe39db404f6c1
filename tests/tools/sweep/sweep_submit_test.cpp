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

TEST_CASE("submit takes nothing but the number of a job from sbatch") {
    const Sweeps sweeps;
    fs::create_directory(sweeps.folder / "bin");
    const fs::path program = sweeps.folder / "bin/sbatch";
    const auto submit_with = [&](const std::string& answer) {
        sweeps.folder.write("bin/sbatch", "#!/bin/sh\nprintf '%b' '" + answer + "'\n");
        fs::permissions(program, fs::perms::owner_all);
        std::vector<std::string> command = tumble::test::tumble_command(
            {"sweep", "submit", sweeps.plan, "-o", sweeps.at("cluster"), "--slurm", "--tasks", "2", "--json"});
        command.insert(command.begin(), {"env", "PATH=" + program.parent_path().string() + ":/usr/bin:/bin"});
        return tumble::test::run(command);
    };
    const Answer accepted = submit_with("123;main\\n");
    REQUIRE_MESSAGE(accepted.code == 0, accepted.err);
    CHECK(json::parse(accepted.out)["job"] == "123");
    for (const char* const garbage : {"Submitted batch job 4\\n", "", "1 $(touch hit)\\n", "\\n", "-1\\n"}) {
        CAPTURE(garbage);
        const Answer refused = submit_with(garbage);
        CHECK(refused.code == 4);
        CHECK(refused.err.find("sbatch --parsable answered no number of a job") != std::string::npos);
    }
}
