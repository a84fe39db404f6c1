// The transform from the world to the pixels of a frame, in the summary of a run and in the answer of `shot`.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

#include "process.hpp"
#include "support/near.hpp"

using nlohmann::json;
using tumble::test::absolute;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::read_text;
using tumble::test::run_tumble;

namespace {

// A puck that moves at 3 m/s without gravity.
std::string puck_scene(const std::string& camera) {
    return R"({"format": 1, "world": {"gravity": [0, 0], "duration": 1}, "camera": )" + camera +
           R"(, "bodies": [{"name": "puck", "velocity": [3, 0], "shapes": [{"circle": {"radius": 0.5}}]}]})";
}

json summary_of(const Folder& folder, const std::string& camera) {
    const std::string scene = folder.write("puck.json", puck_scene(camera));
    const Answer answer =
        run_tumble({"run", scene, "--fps", "2", "--size", "320x180", "--force", "-o", (folder / "out").string()});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    return json::parse(read_text(folder / "out/summary.json"))["view"];
}

}  // namespace

TEST_CASE("the summary has the transform of every frame: one for a fixed camera, one for each frame of a moving one") {
    const Folder folder;
    const json fixed = summary_of(folder, R"({"center": [1, 2], "height": 9})");
    CHECK(fixed["width"] == 320);
    CHECK(fixed["height"] == 180);
    REQUIRE(fixed["from_frame"].size() == 1);
    CHECK(fixed["from_frame"][0]["frame"] == 0);
    CHECK(fixed["from_frame"][0]["center"] == json({1.0, 2.0}));
    CHECK(fixed["from_frame"][0]["pixels_per_metre"] == 20.0);  // 180 / 9

    const json moving = summary_of(folder, R"({"center": [1, 2], "height": 9, "follow": "puck"})");
    REQUIRE(moving["from_frame"].size() == 3);
    CHECK(moving["from_frame"][2]["frame"] == 2);
    CHECK(tumble::test::near(moving["from_frame"][2]["center"][0].get<double>(), 4.0, absolute(1e-5)));  // after 1 s
}

TEST_CASE("shot --json has the transform of its frame") {
    const Folder folder;
    const std::string scene = folder.write("puck.json", puck_scene(R"({"center": [1, 2], "height": 9})"));
    const Answer answer =
        run_tumble({"shot", scene, "--size", "320x180", "-o", (folder / "puck.png").string(), "--json"});
    const json view = json::parse(answer.out)["view"];
    CHECK(view == json({{"width", 320}, {"height", 180}, {"center", {1.0, 2.0}}, {"pixels_per_metre", 20.0}}));
}

TEST_CASE("--hide leaves out parts of the frame and refuses unknown ones") {
    const Folder folder;
    const std::string scene = folder.write("puck.json", puck_scene(R"({"center": [1, 2], "height": 9})"));
    const std::string whole = (folder / "whole.png").string(), bare = (folder / "bare.png").string();
    CHECK(run_tumble({"shot", scene, "-o", whole}).code == 0);
    CHECK(run_tumble({"shot", scene, "-o", bare, "--hide", "title,time,scale,grid,notes"}).code == 0);
    CHECK(read_text(whole) != read_text(bare));
    const std::string all = (folder / "all.png").string();
    CHECK(run_tumble({"shot", scene, "-o", all, "--hide", "all"}).code == 0);
    CHECK(read_text(all) == read_text(bare));
    const Answer wrong = run_tumble({"shot", scene, "-o", all, "--force", "--hide", "bodies"});
    CHECK(wrong.code == 2);
    CHECK(wrong.err.find("expected title,time,scale,grid,notes or all") != std::string::npos);
}

TEST_CASE("key frames of the camera move the transform of the frames") {
    const Folder folder;
    // At 0, 0.5 and 1 s: 3 u^2 - 2 u^3 is 0, 1/2 and 1.
    const json views = summary_of(
        folder,
        R"({"keys": [{"time": 0, "center": [0, 0], "height": 9}, {"time": 1, "center": [4, 2], "height": 18}]})");
    REQUIRE(views["from_frame"].size() == 3);
    CHECK(views["from_frame"][0]["center"] == json({0.0, 0.0}));
    CHECK(views["from_frame"][0]["pixels_per_metre"] == 20.0);
    CHECK(views["from_frame"][1]["center"] == json({2.0, 1.0}));
    CHECK(tumble::test::near(views["from_frame"][1]["pixels_per_metre"].get<double>(), 180.0 / 13.5, absolute(1e-12)));
    CHECK(views["from_frame"][2]["center"] == json({4.0, 2.0}));
    CHECK(views["from_frame"][2]["pixels_per_metre"] == 10.0);
}
