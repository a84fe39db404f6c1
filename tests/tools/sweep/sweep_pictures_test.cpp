// tumble sweep: frames and masks.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "tools/sweep/sweeps.hpp"
#include "tumble/render.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::are_equal;
using tumble::test::read_text;
using tumble::test::run_tumble;
using tumble::test::Sweeps;
using tumble::test::tumble_command;

namespace {

constexpr const char* kPictures = R"({"format": 1, "scene": "scene.json", "runs": 6, "shard_runs": 2,
  "parameters": [{"name": "height", "set": "/bodies/ball/position/1", "range": [1.2, 4]}],
  "set": {"/camera": {"center": [0, 2], "height": 6}},
  "write": {"frames": {"every": 15, "size": [96, 64], "plain": true}, "masks": {"size": [48, 32]}, "summary": true}})";

std::string video_plan() {
    std::string text = kPictures;
    return text.insert(text.find("\"plain\""), "\"as\": \"mp4\", ");
}

// The program with a variable of the environment, "NAME=VALUE".
Answer with_environment(const std::string& variable, const std::vector<std::string>& arguments) {
    std::vector<std::string> command = tumble_command(arguments);
    command.insert(command.begin(), {"/usr/bin/env", variable});
    return tumble::test::run(command);
}

}  // namespace

TEST_CASE("frames and masks of each run are in the tar files, and do not depend on the thread that draws them") {
    const Sweeps sweeps(kPictures);
    REQUIRE(sweeps.sweep("one", {"-j", "1"}).code == 0);
    REQUIRE(sweeps.sweep("three", {"-j", "3"}).code == 0);
    CHECK(are_equal(sweeps.folder / "one", sweeps.folder / "three"));
    const Answer list = tumble::test::run({"/bin/tar", "-tf", sweeps.at("one/shard-000001.tar")});
    std::string expected;
    for (const std::string run : {"000000000002", "000000000003"}) {
        expected += run + ".json\n";
        // 0.5 s are 30 steps.
        for (const std::string step : {"000000", "000015", "000030"})
            expected += run + ".frame." + step + ".png\n" + run + ".mask." + step + ".png\n";
    }
    CHECK(list.out == expected);
    CHECK(run_tumble({"sweep", "verify", sweeps.at("one"), "--part", "1"}).code == 0);
}

TEST_CASE("the frames of a run are those of tumble run, and its masks have the labels of its summary") {
    const Sweeps sweeps(kPictures);
    REQUIRE(sweeps.sweep("out").code == 0);
    REQUIRE(tumble::test::run({"/bin/tar", "-xf", sweeps.at("out/shard-000000.tar"), "-C", sweeps.at("")}).code == 0);
    const json summary = json::parse(read_text(sweeps.folder / "000000000001.json"));
    CHECK(summary["bodies"] == json::array({"floor", "ball"}));
    const std::string height = summary["parameters"]["height"].dump();
    const Answer answer =
        run_tumble({"run", sweeps.at("scene.json"), "-o", sweeps.at("run"), "--size", "48x32", "--fps", "4", "--masks",
                    "--no-frames", "--set", "/camera={\"center\": [0, 2], \"height\": 6}", "--set",
                    "/bodies/ball/position/1=" + height});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const std::vector<std::string> command{"run",    sweeps.at("scene.json"),
                                           "-o",     sweeps.at("frames"),
                                           "--size", "96x64",
                                           "--fps",  "4",
                                           "--hide", "title,time,scale,grid",
                                           "--set",  "/camera={\"center\": [0, 2], \"height\": 6}",
                                           "--set",  "/bodies/ball/position/1=" + height};
    REQUIRE(run_tumble(command).code == 0);
    CHECK(read_text(sweeps.folder / "frames/frames/frame_000001.png") ==
          read_text(sweeps.folder / "000000000001.frame.000015.png"));
    int masks = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(sweeps.folder / "run"))
        if (entry.path().string().find("mask") != std::string::npos && entry.path().extension() == ".png" &&
            read_text(entry.path()) == read_text(sweeps.folder / "000000000001.mask.000015.png"))
            ++masks;
    CHECK(masks == 1);
}

TEST_CASE("a video of each run is in the tar files, with the frames of its pictures, and its bytes repeat") {
    const Sweeps sweeps(video_plan());
    fs::create_directories(sweeps.folder / "temporary");
    REQUIRE(with_environment("TMPDIR=" + sweeps.at("temporary"), sweeps.arguments("one", {"-j", "1"})).code == 0);
    CHECK(fs::is_empty(sweeps.folder / "temporary"));
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // an MP4 can state times in seconds
    REQUIRE(sweeps.sweep("three", {"-j", "3"}).code == 0);
    CHECK(are_equal(sweeps.folder / "one", sweeps.folder / "three"));
    const Answer list = tumble::test::run({"/bin/tar", "-tf", sweeps.at("one/shard-000002.tar")});
    CHECK(list.out.find("000000000005.frames.mp4\n") != std::string::npos);
    CHECK(list.out.find("frame.000") == std::string::npos);
    CHECK(list.out.find("000000000005.mask.000030.png\n") != std::string::npos);
    CHECK(run_tumble({"sweep", "verify", sweeps.at("one"), "--part", "1"}).code == 0);
    // 3 frames, each 15 steps of 1/60 s.
    REQUIRE(tumble::test::run({"/bin/tar", "-xf", sweeps.at("one/shard-000000.tar"), "-C", sweeps.at("")}).code == 0);
    const std::string video = sweeps.at("000000000001.frames.mp4");
    const Answer frames =
        tumble::test::run({"/usr/bin/ffprobe", "-v", "error", "-count_frames", "-show_entries",
                           "stream=nb_read_frames,r_frame_rate,width,height", "-of", "csv=p=0", video});
    CHECK(frames.out == "96,64,4/1,3\n");
    CHECK(read_text(sweeps.folder / "one/manifest.jsonl").find("ffmpeg version ") != std::string::npos);
}

TEST_CASE("without ffmpeg a sweep with videos ends with exit code 5 before it writes, and its sides must be even") {
    std::string text = video_plan();
    const Sweeps sweeps(text);
    const Answer answer = with_environment("PATH=" + sweeps.at(""), sweeps.arguments("out"));
    CHECK(answer.code == 5);
    CHECK_MESSAGE(answer.err.find("the program ffmpeg, which encodes videos, is not installed") != std::string::npos,
                  answer.err);
    CHECK_FALSE(fs::exists(sweeps.folder / "out/manifest.jsonl"));
    text.replace(text.find("[96, 64]"), 8, "[97, 64]");
    const Answer odd = run_tumble({"sweep", sweeps.folder.write("odd.json", text), "--dry-run"});
    CHECK(odd.code == 3);
    CHECK_MESSAGE(odd.err.find("/write/frames/size: must have even sides") != std::string::npos, odd.err);
}

TEST_CASE("the folder of a sweep has the images of its frames, and a damaged image makes a run invalid") {
    const Sweeps sweeps(R"({"format": 1, "scene": "scene.json", "runs": 6, "shard_runs": 2,
      "parameters": [{"name": "image", "set": "/bodies/ball/images/0/file", "list": ["red.png", "damaged.png"]}],
      "set": {"/camera": {"center": [0, 2], "height": 6}}, "write": {"frames": {"size": [96, 64]}}})");
    sweeps.folder.write("scene.json", R"({"format": 1, "world": {"duration": 0.1}, "bodies": [
      {"name": "ball", "position": [0, 2], "images": [{"file": "red.png", "height": 2}],
       "shapes": [{"circle": {"radius": 0.5}}]}]})");
    const tumble::Image red{1, 1, {255, 0, 0, 255}};
    tumble::write_png(red, sweeps.folder / "red.png");
    sweeps.folder.write("damaged.png", "no picture");
    const Answer answer = sweeps.sweep("out", {"-j", "1", "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(json::parse(answer.out)["outcomes"] == json{{"ok", 3}, {"invalid", 3}});
    REQUIRE(sweeps.sweep("three", {"-j", "3"}).code == 0);
    CHECK(are_equal(sweeps.folder / "out", sweeps.folder / "three"));
    CHECK(read_text(sweeps.folder / "out/plan/red.png") == read_text(sweeps.folder / "red.png"));
    fs::remove(sweeps.folder / "red.png");
    const Answer verified = run_tumble({"sweep", "verify", sweeps.at("out"), "--part", "1", "--json"});
    CHECK_MESSAGE(verified.code == 0, verified.out);
    CHECK(json::parse(verified.out)["repeated_runs"] == 6);
    tumble::write_png({1, 1, {0, 0, 255, 255}}, sweeps.folder / "out/plan/red.png");
    CHECK(run_tumble({"sweep", "verify", sweeps.at("out"), "--part", "1"}).code == 7);
}

TEST_CASE("a sweep with frames does not wait for an image that is a pipe") {
    const Sweeps sweeps(R"({"format": 1, "scene": "scene.json", "runs": 2,
      "parameters": [{"name": "image", "set": "/bodies/ball/images/0/file", "list": ["gone.png", "pipe.png"]}],
      "set": {"/camera": {"center": [0, 2], "height": 6}}, "write": {"frames": {"size": [96, 64]}}})");
    sweeps.folder.write("scene.json", R"({"format": 1, "world": {"duration": 0.1}, "bodies": [
      {"name": "ball", "images": [{"file": "gone.png", "height": 2}], "shapes": [{"circle": {"radius": 0.5}}]}]})");
    REQUIRE(mkfifo((sweeps.folder / "pipe.png").c_str(), 0600) == 0);
    std::vector<std::string> command =
        tumble_command({"sweep", sweeps.at("plan.json"), "-o", sweeps.at("out"), "--json"});
    command.insert(command.begin(), {"/usr/bin/timeout", "20"});
    const Answer answer = tumble::test::run(command);
    CHECK(answer.code == 4);
    CHECK_MESSAGE(answer.err.find("pipe.png: is no regular file") != std::string::npos, answer.err);
}

TEST_CASE("a sweep with frames of another renderer is not continued and not compared") {
    const Sweeps sweeps(kPictures);
    REQUIRE(sweeps.sweep("out").code == 0);
    const std::string manifest = read_text(sweeps.folder / "out/manifest.jsonl");
    const std::size_t at = manifest.find("\"frame_software\":\"") + 18;
    REQUIRE(at > 18);
    sweeps.folder.write("out/manifest.jsonl", manifest.substr(0, at) + "another " + manifest.substr(at));
    const Answer sweep = sweeps.sweep("out");
    CHECK(sweep.code == 4);
    CHECK_MESSAGE(sweep.err.find("frames of another") != std::string::npos, sweep.err);
    CHECK(run_tumble({"sweep", "verify", sweeps.at("out")}).code == 4);
}
