// `tumble compare`: its numbers are those of diff, its page and frames, and its errors.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "process.hpp"
#include "support/near.hpp"

using nlohmann::json;
using tumble::test::absolute;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::near;
using tumble::test::read_text;
using tumble::test::relative;
using tumble::test::run_tumble;

namespace {

// A ball in free fall, 1 kg, whose name and scene are markup.
constexpr const char* kFall = R"({
  "format": 1, "name": "</script><img src=x>",
  "world": {"duration": 1, "steps_per_second": 100},
  "bodies": [{"name": "</script>\"'ball", "position": [0, 10], "velocity": [1, 0],
              "shapes": [{"circle": {"radius": 0.5}}]}]
})";

std::vector<std::vector<double>> numbers_of(const std::string& csv) {
    std::vector<std::vector<double>> rows;
    std::istringstream lines(csv);
    std::string line;
    for (std::getline(lines, line); std::getline(lines, line);) {
        std::istringstream fields(line);
        rows.emplace_back();
        for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(std::stod(field));
    }
    return rows;
}

}  // namespace

TEST_CASE("the largest numbers of compare are those of diff, of which each step is one") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", tumble::test::small_scene());
    const std::string csv = (folder / "c.csv").string(), change = "/world/gravity=[0.5,-9]";
    const Answer answer = run_tumble({"compare", scene, scene, "--set", change, "--csv", csv, "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json diff = json::parse(run_tumble({"diff", scene, scene, "--set", change, "--json"}).out);
    CHECK(json::parse(answer.out) == diff);
    const auto rows = numbers_of(read_text(csv));
    REQUIRE(rows.size() > 10);
    const std::vector<std::string> kinds{"position", "angle", "velocity", "angular velocity"};
    for (const json& largest : diff["largest"]) {
        const auto kind = std::ranges::find(kinds, largest["of"].get<std::string>()) - kinds.begin();
        const auto column = static_cast<std::size_t>(2 + kind);
        CAPTURE(column);
        const auto row = std::ranges::max_element(rows, {}, [column](const auto& r) { return r[column]; });
        CHECK((*row)[column] == largest["apart"].get<double>());
        CHECK((*row)[0] == largest["step"].get<double>());
    }
    CHECK(diff["largest"].size() >= 2);
}

TEST_CASE("compare of engines has the energy of a falling ball in both, and the first step that parts them") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kFall), csv = (folder / "c.csv").string();
    const Answer answer =
        run_tumble({"compare", scene, "--engine", "box2d", "--csv", csv, "--set",
                    "/materials={\"m\":{\"density\":1.2732395447351628}}", "--set", "/bodies/0/shapes/0/material=m"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(answer.out.find(" beside Box2D 2.4") != std::string::npos);
    const auto rows = numbers_of(read_text(csv));
    REQUIRE(rows.size() == 101);
    // 1 kg (density 4 / pi, radius 0.5) at a height of 10 m, 1 m/s, under the scenes' gravity of 10 m/s^2: 100 + 0.5 J.
    for (const std::size_t column : {6u, 7u}) CHECK(near(rows[0][column], 100.5, relative(1e-6)));
    // Box2D integrates with the velocity at the end of a step: after n steps of h it is g h^2 n / 2 below the parabola,
    // on which tumble stays.
    for (const std::size_t n : {1u, 50u, 100u})
        CHECK(near(rows[n][2], 0.5 * 10.0 * 1e-4 * static_cast<double>(n), absolute(2e-5)));
    // 1.02 cm apart after 20.4 steps.
    const Answer parted = run_tumble({"compare", scene, "--engine", "box2d", "--csv", "-", "--tolerance", "0.0102"});
    CHECK(parted.err.find("the first difference is at step 21 ") != std::string::npos);
}

TEST_CASE("the page of compare has pictures and plots, and text of the scene is no markup") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kFall), page = (folder / "c.html").string();
    const Answer answer = run_tumble({"compare", scene, "--engine", "box2d", "-o", page, "--size", "160x90"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const std::string text = read_text(page);
    CHECK(text.find("</script>") == std::string::npos);
    CHECK(text.find("<img src=x>") == std::string::npos);
    CHECK(text.find("http") == std::string::npos);
    CHECK(text.find("&lt;/script&gt;") != std::string::npos);
    CHECK(text.find("src=\"data:image/png;base64,iVBORw0KGgo") != std::string::npos);
    CHECK(text.find("Kinetic and potential energy") != std::string::npos);
    CHECK(text.find("1 cm apart") != std::string::npos);
    CHECK(run_tumble({"compare", scene, "--engine", "box2d", "-o", page}).code == 4);
}

TEST_CASE("the frames of compare are one for each time, side by side or over each other, above the plot") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kFall);
    for (const bool is_overlaid : {false, true}) {
        const std::filesystem::path frames = folder / (is_overlaid ? "over" : "beside");
        std::vector<std::string> command{"compare",       scene,   "--engine", "box2d",  "--frames",
                                         frames.string(), "--fps", "10",       "--size", "400x100"};
        if (is_overlaid) command.emplace_back("--overlaid");
        const Answer answer = run_tumble(command);
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        CHECK(std::distance(std::filesystem::directory_iterator(frames), {}) == 11);
        const std::string png = read_text(frames / "frame_000010.png");
        const auto side = [&](std::size_t at) {
            return static_cast<unsigned char>(png[at + 2]) * 256 + static_cast<unsigned char>(png[at + 3]);
        };
        CHECK(side(16) == (is_overlaid ? 400 : 804));
        CHECK(side(20) == 280);
    }
}

TEST_CASE("trajectories are compared without pictures, and wrong arguments of compare end with exit code 2") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kFall), table = (folder / "t.csv").string();
    REQUIRE(run_tumble({"run", scene, "--no-frames", "-o", (folder / "r").string(), "--trajectory", table}).code == 0);
    const std::string csv = (folder / "c.csv").string();
    REQUIRE(run_tumble({"compare", table, scene, "--csv", csv, "-o", (folder / "c.html").string()}).code == 0);
    const auto rows = numbers_of(read_text(csv));
    REQUIRE(rows.size() == 101);
    for (const auto& row : rows) CHECK(row[2] == 0.0);
    CHECK(read_text(folder / "c.html").find("<img") == std::string::npos);
    for (const std::vector<std::string>& wrong :
         std::vector<std::vector<std::string>>{{"compare", scene, scene},
                                               {"compare", scene, "--csv", csv},
                                               {"compare", scene, scene, "--engine", "box2d", "--csv", csv},
                                               {"compare", table, "--engine", "box2d", "--csv", csv},
                                               {"compare", scene, "--engine", "bullet", "--csv", csv},
                                               {"compare", scene, table, "--seed", "3", "--csv", csv}})
        CHECK(run_tumble(wrong).code == 2);
}
