// Claims that `check` decides beside the run: pictures and ratios of times. And stops, random numbers and conditions at
// the command line.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

#include "process.hpp"

using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::read_text;
using tumble::test::run_tumble;

namespace {

// A falling ball, with these claims and further members.
std::string falling_ball(const std::string& claims, const std::string& more = "") {
    return R"({"format": 1, "world": {"duration": 1}, "camera": {"center": [0, 0], "height": 12}, "bodies": [
        {"name": "ball", "shapes": [{"circle": {"radius": 1}}]}], )" +
           more + R"("expect": [)" + claims + "]}";
}

json expectation_of(const Answer& answer) { return json::parse(answer.out)["scenes"][0]["expectations"][0]; }

}  // namespace

TEST_CASE("a picture claim compares the frame at its time with a PNG file beside the scene") {
    const Folder folder;
    const std::string scene =
        folder.write("ball.json", falling_ball(R"({"picture": "golden.png", "at": 0.5, "tolerance": 2})"));
    const Answer missing = run_tumble({"check", scene});
    CHECK(missing.code == 4);
    CHECK(missing.out.find("golden.png") != std::string::npos);
    const std::string golden = (folder / "golden.png").string();
    REQUIRE(run_tumble({"shot", scene, "-o", golden, "--at", "0.5", "--size", "64x48"}).code == 0);
    const Answer same = run_tumble({"check", scene, "--json"});
    CHECK(same.code == 0);
    CHECK(expectation_of(same)["finding"] == "the largest difference is 0 levels");
    CHECK(expectation_of(same)["step"] == 30);
    const Answer moved = run_tumble({"check", scene, "--json", "--set", "/bodies/ball/position=[3,0]"});
    CHECK(moved.code == 7);
    CHECK(expectation_of(moved)["finding"].get<std::string>().find(" pixels differ, by up to ") != std::string::npos);
    CHECK(
        run_tumble({"check", scene, "--set", "/bodies/ball/position=[3,0]", "--set", "/expect/0/tolerance=255"}).code ==
        0);
    const Answer late = run_tumble({"check", scene, "--json", "--set", "/expect/0/at=3"});
    CHECK(late.code == 7);
    CHECK(expectation_of(late)["finding"] == "the run ends before that");
}

TEST_CASE("no claim passes that was left undecided because a picture is missing") {
    const Folder folder;
    const std::string scene =
        folder.write("ball.json", falling_ball(R"({"picture": "golden.png"}, {"picture": "other.png"})"));
    const Answer missing = run_tumble({"check", scene, "--json", "--junit", (folder / "report.xml").string()});
    CHECK(missing.code == 4);
    const json claims = json::parse(missing.out)["scenes"][0]["expectations"];
    REQUIRE(claims.size() == 2);
    for (const json& claim : claims) {
        CHECK(claim["passed"] == false);
        CHECK(claim["finding"] == "it was not decided, because the scene could not be checked");
    }
    CHECK(read_text(folder / "report.xml").find("tests=\"3\" failures=\"2\" errors=\"1\"") != std::string::npos);
}

TEST_CASE("check --update draws the pictures that are missing, and leaves the others") {
    const Folder folder;
    const std::string scene =
        folder.write("ball.json", falling_ball(R"({"picture": "golden/half.png", "at": 0.5}, {"picture": "end.png"},
                                   {"picture": "late.png", "at": 3})"));
    CHECK(run_tumble({"check", scene}).out.find("`tumble check --update` writes it") != std::string::npos);
    const Answer updated = run_tumble({"check", scene, "--update", "--json"});
    CHECK(updated.code == 7);  // the run ends before 3 s
    const json written = json::parse(updated.out)["scenes"][0]["pictures"];
    REQUIRE(written.size() == 2);
    CHECK(written[0]["pointer"] == "/expect/0/picture");
    CHECK(written[0]["file"] == (folder / "golden/half.png").string());
    CHECK(written[1]["pointer"] == "/expect/1/picture");
    CHECK_FALSE(std::filesystem::exists(folder / "late.png"));

    // It is the frame of that time.
    REQUIRE(run_tumble({"shot", scene, "-o", (folder / "shot.png").string(), "--at", "0.5"}).code == 0);
    const std::string half = read_text(folder / "golden/half.png");
    CHECK(half == read_text(folder / "shot.png"));

    // A picture that is there stays, whether its claim holds or not.
    const Answer again = run_tumble({"check", scene, "--update", "--json"});
    CHECK_FALSE(json::parse(again.out)["scenes"][0].contains("pictures"));
    CHECK(json::parse(again.out)["scenes"][0]["expectations"][0]["finding"] == "the largest difference is 0 levels");
    folder.write("end.png", half);
    const Answer text = run_tumble({"check", scene, "--update"});
    CHECK(text.out.find("/expect/1 failed: expected that") != std::string::npos);
    CHECK(text.out.find("to accept the new frame, delete the file and update again") != std::string::npos);
    CHECK(read_text(folder / "end.png") == half);
    std::filesystem::remove(folder / "end.png");
    CHECK(run_tumble({"check", scene, "--update"})
              .out.find("/expect/1/picture was missing; written to " + (folder / "end.png").string()) !=
          std::string::npos);
}

TEST_CASE("a claim on a ratio of times steps the reference scene too") {
    const Folder folder;
    folder.write("small.json", falling_ball(""));
    folder.write(
        "large.json",
        R"({"format": 1, "world": {"duration": 1, "sleeping": false}, "bodies": [{"name": "floor", "type": "static",
                     "shapes": [{"box": {"size": [90, 1]}}]}, {"name": "crate", "position": [-20, 1.01], "repeat": {"grid":
                     {"columns": 40, "rows": 10, "spacing": [1, 1.02]}}, "shapes": [{"box": {"size": [0.9, 1]}}]}]})");
    const std::string slow =
        folder.write("slow.json", falling_ball(R"({"max_time_ratio": 1e-6, "reference": "large.json"})"));
    const std::string fast =
        folder.write("fast.json", falling_ball(R"({"max_time_ratio": 0.5, "reference": "large.json"})"));
    const Answer failed = run_tumble({"check", slow, "--json"});
    CHECK(failed.code == 7);
    CHECK(expectation_of(failed)["finding"].get<std::string>().starts_with("it takes "));
    CHECK(run_tumble({"check", fast}).code == 0);
    const std::string lost =
        folder.write("lost.json", falling_ball(R"({"max_time_ratio": 1, "reference": "no.json"})"));
    CHECK(run_tumble({"check", lost}).code == 4);
}

TEST_CASE("a stop ends run and check, which is no failure") {
    const Folder folder;
    const std::string scene = folder.write(
        "ball.json",
        falling_ball(R"({"that": "ball.y < -0.5"})", R"("timeline": [{"when": "ball.y < -0.5", "stop": true}], )"));
    const Answer checked = run_tumble({"check", scene, "--json"});
    CHECK(checked.code == 0);
    // 0.5 m of free fall take 0.32 s.
    const int steps = json::parse(checked.out)["scenes"][0]["steps"].get<int>();
    CHECK(steps >= 18);
    CHECK(steps <= 20);
    const Answer run = run_tumble({"run", scene, "-o", (folder / "out").string(), "--no-frames", "--json"});
    CHECK(run.code == 0);
    CHECK(json::parse(run.out)["complete"] == true);
    CHECK(json::parse(run.out)["steps"] == steps);
    CHECK(run_tumble({"diff", scene, scene}).code == 0);
}

TEST_CASE("the summary lists what was drawn, and --seed draws again") {
    const Folder folder;
    const std::string scene = folder.write(
        "ball.json",
        R"({"format": 1, "world": {"duration": 0.1}, "bodies": [{"name": "ball", "velocity": [{"uniform": [1, 2]}, 0],
                         "shapes": [{"circle": {"radius": 1}}]}]})");
    const auto drawn = [&](const char* seed, const char* out) {
        const Answer answer =
            run_tumble({"run", scene, "-o", (folder / out).string(), "--no-frames", "--json", "--seed", seed});
        return json::parse(answer.out)["draws"]["/bodies/ball/velocity/0"].get<double>();
    };
    const double first = drawn("1", "a");
    CHECK((first >= 1.0 && first < 2.0));
    CHECK(drawn("1", "b") == first);
    CHECK(drawn("2", "c") != first);
    CHECK(run_tumble({"fmt", scene}).out.find(R"({"uniform": [1, 2]})") != std::string::npos);
}

TEST_CASE("an error in a condition is shown with a caret at its place") {
    const Folder folder;
    const std::string scene = folder.write("ball.json", falling_ball(R"({"that": "ball.x < bell.x"})"));
    const Answer answer = run_tumble({"validate", scene});
    CHECK(answer.code == 3);
    CHECK(answer.err.find("there is no body or joint 'bell'") != std::string::npos);
    CHECK(answer.err.find("hint: did you mean 'ball'?") != std::string::npos);
}
