// `run --report`: the page, the findings in the summary, the exit code.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include "process.hpp"
#include "support/near.hpp"

using nlohmann::json;
using tumble::test::absolute;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::kDouble;
using tumble::test::near;
using tumble::test::read_text;
using tumble::test::run_tumble;

namespace {

// Two crates, one inside the other. The name must not become markup.
const std::string kName = R"(<script>alert('x')</script>&)";
const std::string kOverlapping =
    R"({"format": 1, "name": "overlapping", "world": {"duration": 1}, "bodies": [
        {"name": "floor", "type": "static", "position": [0, -0.5], "shapes": [{"box": {"size": [20, 1]}}]},
        {"name": "crate", "position": [0, 0.5], "shapes": [{"box": {"size": [1, 1]}}]},
        {"name": ")" +
    kName + R"(", "position": [0.2, 0.7], "shapes": [{"box": {"size": [1, 1]}}]}]})";

Answer run_scene(const Folder& folder, const std::string& scene, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"run", scene, "--no-frames", "--force", "-o", (folder / "out").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_tumble(arguments);
}

json summary_of(const Folder& folder) { return json::parse(read_text(folder / "out/summary.json")); }

}  // namespace

TEST_CASE("a report has each finding with its text, its remedy and a picture, and names are text in it") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kOverlapping);
    const std::string page = (folder / "health.html").string();
    const Answer answer = run_scene(folder, scene, {"--report", page});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(answer.out.find("1 finding\n") != std::string::npos);
    const std::string html = read_text(page);
    CHECK(html.starts_with("<!doctype html>"));
    CHECK(html.find("&lt;script&gt;alert") != std::string::npos);
    CHECK(html.find("<script") == std::string::npos);
    CHECK(html.find("inside &#39;crate&#39;") + html.find("inside 'crate'") != 2 * std::string::npos);
    CHECK(html.find("Remedy: Move one of them") != std::string::npos);
    CHECK(html.find("src=\"data:image/png;base64,") != std::string::npos);
    CHECK(html.find("<svg") != std::string::npos);
}

TEST_CASE("the summary of a run with a report has its findings, and the run is the same without one") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kOverlapping);
    REQUIRE(run_scene(folder, scene, {}).code == 0);
    const json plain = summary_of(folder);
    CHECK_FALSE(plain.contains("health"));
    REQUIRE(run_scene(folder, scene, {"--report", (folder / "health.html").string()}).code == 0);
    const json reported = summary_of(folder);
    CHECK(reported["state_hash"] == plain["state_hash"]);
    const json& finding = reported["health"]["findings"].at(0);
    CHECK(finding["check"] == "overlap");
    CHECK(finding["bodies"] == json::array({"crate", kName}));
    CHECK(finding["step"] == 1);
    CHECK(near(finding["value"].get<double>(), 0.8, absolute(1e-6)));  // 1 - 0.2, in float
    CHECK(near(finding["limit"].get<double>(), 0.01, kDouble));
    CHECK(finding["unit"] == "m");
    CHECK(reported["health"]["extremes"].at(0)["quantity"] == "deepest overlap");
    CHECK(reported["health"]["slow_steps"].size() == 5);
}

TEST_CASE("findings are no failure, unless --fail-on-findings is given") {
    const Folder folder;
    const std::string faulty = folder.write("faulty.json", kOverlapping);
    const std::string sound = folder.write("sound.json", tumble::test::small_scene());
    const std::string page = (folder / "health.html").string();
    CHECK(run_scene(folder, faulty, {"--report", page}).code == 0);
    CHECK(run_scene(folder, faulty, {"--report", page, "--fail-on-findings"}).code == 7);
    CHECK(run_scene(folder, sound, {"--report", page, "--fail-on-findings"}).code == 0);
    CHECK(read_text(page).find("No check has found a fault.") != std::string::npos);
    CHECK(run_scene(folder, faulty, {"--fail-on-findings"}).code == 2);
    CHECK(run_scene(folder, faulty, {"--report", page, "--checkpoint", "1"}).code == 2);
}

TEST_CASE("a damaged picture of a body costs a report its pictures alone") {
    const Folder folder;
    folder.write("body.bmp", "BM");
    const std::string scene =
        folder.write("scene.json", R"({"format": 1, "world": {"duration": 0.1, "gravity": [0, 0]}, "bodies": [
            {"name": "a", "shapes": [{"circle": {"radius": 0.5}}], "images": [{"file": "body.bmp", "height": 1}]},
            {"name": "b", "position": [0.3, 0], "shapes": [{"circle": {"radius": 0.5}}]}]})");
    const std::string page = (folder / "health.html").string();
    const Answer answer = run_scene(folder, scene, {"--report", page});
    CHECK(answer.code == 0);
    CHECK_MESSAGE(answer.err.find("body.bmp: the BMP file is not complete") != std::string::npos, answer.err);
    const std::string html = read_text(page);
    CHECK(html.find("Pictures are missing: ") != std::string::npos);
    CHECK(html.find("Remedy: ") != std::string::npos);
    CHECK(html.find("<img") == std::string::npos);
}

TEST_CASE("a run that diverges leaves a report of the steps before") {
    const Folder folder;
    const std::string scene = folder.write(
        "scene.json", R"({"format": 1, "name": "mote", "world": {"duration": 1, "gravity": [0, 0]}, "bodies": [
            {"name": "mote", "mass": {"mass": 1e-30, "inertia": 0}, "shapes": [{"circle": {"radius": 0.5}}]}],
            "timeline": [{"at": 0.5, "body": "mote", "impulse": [1e12, 0]}]})");
    const std::string page = (folder / "health.html").string();
    CHECK(run_scene(folder, scene, {"--report", page}).code == 6);
    CHECK(read_text(page).find("The run ended with an error: ") != std::string::npos);
}
