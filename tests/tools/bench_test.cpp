// `tumble bench`: what it times, and what it writes.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "process.hpp"
#include "support/near.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::kDouble;
using tumble::test::near;
using tumble::test::read_text;
using tumble::test::run_tumble;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A program that answers as the benchmark of Box2D v3 does: it has a scene, `pyramid`, of 7 steps of 2 ms.
std::string write_v3_program(const Folder& folder, const std::string& at_end = "exit 0") {
    std::string program = folder.write("benchmark",
                                       "#!/bin/sh\n"
                                       "echo \"$@\" >> \"${0%/*}/calls\"\n"
                                       "touch \"written here\"\n"
                                       "if [ \"$1\" = -l ]; then\n"
                                       "  echo 'Registered benchmarks:'; echo '   0  pyramid'; exit 0\n"
                                       "fi\n"
                                       "echo 'benchmark: pyramid, steps = 7'\n"
                                       "echo 'run 0 : 14.0 (ms)'\n" +
                                           at_end + "\n");
    fs::permissions(program, fs::perms::owner_all);
    return program;
}

}  // namespace

TEST_CASE("bench times both engines on the same scenes") {
    const Answer answer =
        run_tumble({"bench", "--pairs", "64", "--scenes", "pyramid,arch", "--steps", "5", "--runs", "1", "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json result = json::parse(answer.out);
    for (const char* key : {"distance", "step", "render", "machine"}) CHECK(result.contains(key));
    REQUIRE(result["distance"].size() > 16);
    for (const json& query : result["distance"]) {
        CHECK(query["case"].is_string());
        CHECK(near(query["ratio"].get<double>(), query["box2d_ns"].get<double>() / query["tumble_ns"].get<double>(),
                   kDouble));
    }
    REQUIRE(result["step"].size() == 2);
    const json& row = result["step"][0];
    CHECK(row["scene"] == "pyramid");
    CHECK(row["bodies"] == 211);
    CHECK(row["contacts"].get<int>() > 0);
    CHECK(near(row["ratio"].get<double>(), row["box2d_ms"].get<double>() / row["tumble_ms"].get<double>(), kDouble));
    CHECK(run_tumble({"bench", "--pairs", "0", "--scenes", "no_such_scene"}).code == 4);
}

TEST_CASE("bench makes the events of a timeline happen, which Box2D does not run") {
    const Folder folder;
    const std::string scene = folder.write("gate.json", R"({"format": 1, "bodies": [{"name": "gate", "type": "static",
        "shapes": [{"box": {"size": [9, 1]}}]}, {"position": [0, 1], "shapes": [{"box": {"size": [1, 1]}}]}],
        "timeline": [{"at": 0.1, "despawn": "gate"}]})");
    const Answer answer =
        run_tumble({"bench", "--pairs", "0", "--scenes", scene, "--steps", "20", "--runs", "1", "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json row = json::parse(answer.out)["step"][0];
    CHECK(row["bodies"] == 1);
    CHECK(row["contacts"] == 0);
    CHECK(row["tumble_ms"].get<double>() > 0.0);
    CHECK_FALSE(row.contains("box2d_ms"));
    CHECK_FALSE(row.contains("ratio"));
    const Answer text = run_tumble({"bench", "--pairs", "0", "--scenes", scene, "--steps", "20", "--runs", "1"});
    CHECK(contains(text.out, "            -       -"));
}

TEST_CASE("bench does not step a run that its timeline has ended") {
    const Folder folder;
    const std::string scene = folder.write("stop.json", R"({"format": 1, "bodies": [{"name": "ball",
        "shapes": [{"circle": {"radius": 1}}]}], "timeline": [{"at": 0.05, "stop": true},
        {"at": 0.1, "despawn": "ball"}]})");
    const Answer answer =
        run_tumble({"bench", "--pairs", "0", "--scenes", scene, "--steps", "20", "--runs", "1", "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(json::parse(answer.out)["step"][0]["bodies"] == 1);
}

TEST_CASE("the report of bench has a plot and a table of queries and of scenes, and the stages of the steps") {
    const Folder folder;
    const std::string report = folder / "bench.html";
    const std::vector<std::string> bench = {"bench", "--pairs", "16", "--scenes", "pyramid,crane", "--steps",
                                            "5",     "--runs",  "1",  "--report", report,          "--json"};
    const Answer answer = run_tumble(bench);
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const std::string page = read_text(report);
    for (const char* part : {"<svg", "Scenes: ratio of the times", "Queries: ratio of the times", "Stages of a step",
                             "pyramid", "crane", "manifold box-box cold", "solve"})
        CHECK_MESSAGE(contains(page, part), part);
    const json stages = json::parse(answer.out)["step"][0]["stages"];
    double sum = 0.0;
    for (const char* stage : {"pairs", "collide", "prepare", "solve", "continuous", "proxies", "events", "sleep"})
        sum += stages[stage].get<double>();
    CHECK(stages["solve"].get<double>() > 0.0);
    CHECK(sum <= stages["step"].get<double>() * (1.0 + 1e-12));  // both are sums of rounded times
    CHECK(run_tumble(bench).code == 4);                          // the report exists
}

TEST_CASE("bench measures the growth of a pile, of rain and of a sleeping city") {
    const Folder folder;
    const std::string report = folder / "growth.html";
    std::vector<std::string> bench = {"bench", "--pairs", "0", "--scenes", "pyramid", "--steps",
                                      "1",     "--runs",  "1", "--growth", "1000"};
    std::vector<std::string> with_report = bench;
    with_report.insert(with_report.end(), {"--report", report, "--json"});
    const Answer answer = run_tumble(with_report);
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json rows = json::parse(answer.out)["growth"];
    REQUIRE(rows.size() == 3);
    CHECK(rows[0]["world"] == "pile");
    CHECK(rows[0]["awake"] == 999);
    CHECK(rows[1]["world"] == "rain");
    CHECK(rows[1]["awake"] == 999);
    CHECK(rows[2]["world"] == "sleeping city");
    CHECK(rows[2]["awake"] == 9);
    for (const json& row : rows) {
        CHECK(row["bodies"] == 1000);
        CHECK(row["bytes"].get<double>() > 400.0);
        for (const char* time : {"load_us", "build_us", "step_us", "frame_ms"}) CHECK(row[time].get<double>() > 0.0);
    }
    CHECK(rows[2]["step_us"].get<double>() < 0.2 * rows[0]["step_us"].get<double>());
    const std::string page = read_text(report);
    for (const char* part : {"Growth", "Time of a step for each body", "sleeping city"})
        CHECK_MESSAGE(contains(page, part), part);
    bench.back() = "999";
    CHECK(run_tumble(bench).code == 2);
    bench.back() = "1000001";
    CHECK(run_tumble(bench).code == 2);
}

TEST_CASE("bench times the scenes of Box2D v3's benchmark with its program") {
    const Folder folder;
    const std::string program = write_v3_program(folder);
    const Answer answer = run_tumble({"bench", "--pairs", "0", "--scenes", "pyramid,arch", "--steps", "3", "--runs",
                                      "2", "--box2d-v3", program, "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json rows = json::parse(answer.out)["step"];
    CHECK(rows[0]["box2d_v3_ms"] == 2.0);
    CHECK(near(rows[0]["ratio_v3"].get<double>(), 2.0 / rows[0]["tumble_ms"].get<double>(), kDouble));
    CHECK_FALSE(rows[1].contains("box2d_v3_ms"));
    CHECK(read_text(folder / "calls") == "-l\n-t=1 -w=1 -r=1 -b=pyramid\n-t=1 -w=1 -r=1 -b=pyramid\n");
    CHECK_FALSE(fs::exists(folder / "written here"));
    CHECK_FALSE(fs::exists("written here"));
}

TEST_CASE("a program that is not Box2D v3's benchmark, or fails, ends bench with a reason") {
    const Folder folder;
    const auto bench_with = [](const std::string& program) {
        return run_tumble(
            {"bench", "--pairs", "0", "--scenes", "pyramid", "--steps", "3", "--runs", "1", "--box2d-v3", program});
    };
    const Answer other = bench_with("/bin/true");
    CHECK(other.code == 3);
    CHECK_MESSAGE(contains(other.err, "/bin/true lists no scenes"), other.err);
    const Answer no_program = bench_with(folder.write("text", "no program"));
    CHECK(no_program.code == 3);
    CHECK_MESSAGE(contains(no_program.err, "cannot start"), no_program.err);
    const Answer failing = bench_with(write_v3_program(folder, "exit 5"));
    CHECK(failing.code == 3);
    CHECK_MESSAGE(contains(failing.err, "-b=pyramid failed"), failing.err);
    CHECK(bench_with((folder / "none").string()).code == 2);
}
