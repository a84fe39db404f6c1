// `tumble plot`: its tables, pictures, summaries and errors.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "process.hpp"

using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::read_text;
using tumble::test::run_tumble;

namespace {

// A ball in free fall beside one with a name that is no word, and one that is spawned at 0.5 s.
constexpr const char* kPlotted = R"({
  "format": 1, "name": "</script><b>\"fall\"",
  "world": {"duration": 1, "steps_per_second": 60},
  "bodies": [
    {"name": "ball", "position": [0, 10], "shapes": [{"circle": {"radius": 0.5}}]},
    {"name": "</script>, \"x\"", "position": [5, 10], "velocity": [1, 0], "shapes": [{"circle": {"radius": 0.5}}]}
  ],
  "timeline": [{"at": 0.5, "spawn": {"name": "late", "position": [9, 2], "shapes": [{"circle": {"radius": 0.2}}]}}]
})";

std::vector<std::vector<std::string>> rows_of(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        rows.emplace_back();
        for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
    }
    return rows;
}

}  // namespace

TEST_CASE("plot writes the values of each step, those that the trajectory of a run has") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kPlotted), table = (folder / "t.csv").string();
    const Answer answer = run_tumble({"plot", scene, "ball.y", "ball.vy", "late.x", "-o", table});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const auto rows = rows_of(read_text(table));
    CHECK(rows.front() == std::vector<std::string>{"step", "time", "ball.y", "ball.vy", "late.x"});
    REQUIRE(rows.size() == 62);
    const Answer run = run_tumble({"run", scene, "--no-frames", "-o", (folder / "run").string(), "--trajectory", "-"});
    std::size_t compared = 0;
    for (const auto& row : rows_of(run.out)) {
        if (row.size() < 9 || row[2] != "ball") continue;
        const auto& mine = rows.at(1 + std::stoul(row[0]));
        CHECK(mine[1] == row[1]);
        CHECK(mine[2] == row[4]);
        CHECK(std::stod(mine[3]) == std::stof(row[7]));
        ++compared;
    }
    CHECK(compared == 61);
    // The body does not exist before its event, which the step that begins at 0.5 s applies.
    CHECK(rows.at(1 + 30)[4] == "nan");
    CHECK(rows.at(1 + 31)[4] == "9");
}

TEST_CASE("plot takes expressions of the grammar, quoted names, --set, --duration and standard output") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kPlotted);
    const std::string quoted = R"('</script>, "x"'.x)";
    const Answer answer = run_tumble({"plot", scene, quoted, "ball.y > 20 or true", "time^2", "-o", "-", "--duration",
                                      "0.1", "--set", "/bodies/0/position/1=3"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(answer.out.starts_with("step,time,\"'</script>, \"\"x\"\"'.x\",ball.y > 20 or true,time^2\n0,0,5,1,0\n"));
    const auto rows = rows_of(answer.out);
    REQUIRE(rows.size() == 8);
    const double time = std::stod(rows.back()[1]);
    CHECK(std::stod(rows.back()[4]) == time * time);
    CHECK(answer.err.find("unknown") == std::string::npos);
}

TEST_CASE("texts of scenes and expressions are no markup in a plot") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kPlotted), file = (folder / "p.svg").string();
    REQUIRE(run_tumble({"plot", scene, R"('</script>, "x"'.x)", "-o", file}).code == 0);
    const std::string svg = read_text(file);
    CHECK(svg.find("</script>") == std::string::npos);
    CHECK(svg.find("<b>") == std::string::npos);
    CHECK(svg.find("&lt;/script&gt;, &quot;x&quot;") != std::string::npos);
}

TEST_CASE("plot --json tells the extremes, their times and the unknown states") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kPlotted), file = (folder / "p.png").string();
    const Answer answer = run_tumble({"plot", scene, "-o", file, "--json", "--against", "late.x", "ball.y", "step"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(read_text(file).starts_with("\x89PNG"));
    const json result = json::parse(answer.out);
    CHECK(result["complete"] == true);
    const json& height = result["expressions"][0];
    CHECK(height["expression"] == "ball.y");
    CHECK(height["greatest"] == 10.0);
    CHECK(height["greatest_time"] == 0.0);
    CHECK(height["least_time"] == 1.0);
    CHECK(height["least"] == height["last"]);
    CHECK(result["expressions"][1]["last"] == 60);
    CHECK(result["expressions"][2]["unknown"] == 31);  // the states 0 to 30
}

TEST_CASE("an expression that is wrong is shown with its place, and nothing is written") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kPlotted), file = (folder / "p.csv").string();
    const Answer answer = run_tumble({"plot", scene, "1 + bal.y", "-o", file});
    CHECK(answer.code == 2);
    CHECK_MESSAGE(answer.err.find("there is no body or joint 'bal'; did you mean 'ball'?\n  1 + bal.y\n      ^\n") !=
                      std::string::npos,
                  answer.err);
    CHECK(!std::filesystem::exists(file));
    folder.write("p.csv", "mine");
    CHECK(run_tumble({"plot", scene, "ball.y", "-o", file}).code == 4);
    CHECK(read_text(file) == "mine");
    CHECK(run_tumble({"plot", scene, "ball.y", "-o", file, "--force"}).code == 0);
}
