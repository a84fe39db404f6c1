// tumble sweep export: the trajectories of a sweep as a dataset of Minari.
#include <doctest/doctest.h>

#include <chrono>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "support/small_disk.hpp"
#include "sweep/hdf5_contents.hpp"
#include "tools/sweep/sweeps.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::are_equal;
using tumble::test::files_of;
using tumble::test::flip_byte;
using tumble::test::read_text;
using tumble::test::run_tumble;
using tumble::test::Sweeps;

namespace {

// A ball falls for half a second, or until it is below y = 1.3. A trajectory has each tenth step.
constexpr const char* kFallPlan = R"({"format": 1, "scene": "fall.json", "shard_runs": 5, "seeds": [7],
  "parameters": [{"name": "height", "set": "/bodies/0/position/1", "list": [1.35, 1.6, 2, 3]},
                 {"name": "word", "set": "/description", "list": ["a, \"b\"", "c"]},
                 {"name": "radius", "set": "/bodies/0/shapes/0/circle/radius", "list": [0.5, -1]}],
  "measures": [{"name": "y", "value": "ball.y"}], "write": {"trajectory": {"every": 10}}})";
constexpr const char* kFallScene = R"({"format": 1, "world": {"duration": 0.5},
  "bodies": [{"name": "ball", "position": [0, 2], "shapes": [{"circle": {"radius": 0.5}}]}],
  "timeline": [{"when": "ball.y < 1.3", "stop": true}]})";

struct Fall : Sweeps {
    Fall() : Sweeps(kFallPlan) {
        folder.write("fall.json", kFallScene);
        REQUIRE(sweep("out").code == 0);
    }
    Answer to_minari(const std::string& root, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> all{"sweep", "export", at("out"), "-o", at(root), "--id", "falls/ball-v0"};
        all.insert(all.end(), more.begin(), more.end());
        return run_tumble(all);
    }
};

}  // namespace

TEST_CASE("export writes an episode for each run that came to its end, and says what all have in common") {
    const Fall fall;
    const Answer answer = fall.to_minari("sets", {"--reward", "y", "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json report = json::parse(answer.out);
    CHECK(report["dataset"] == fall.at("sets/falls/ball-v0"));
    CHECK(report["episodes"] == 6);
    // From 1.35 m the ball falls by 0.05 m in 0.1 s, before the tenth step: two runs have one state. Eight have a
    // radius of -1.
    CHECK(report["left_out"] == 10);
    // sqrt(0.3 / 5) s are 14.7 steps, sqrt(0.7 / 5) s are 22.4, and from 3 m the ball does not fall to 1.3 m in 30.
    CHECK(report["steps"] == 2 * (1 + 2 + 3));
    const fs::path data = fall.folder / "sets/falls/ball-v0/data";
    const json metadata = json::parse(read_text(data / "metadata.json"));
    CHECK(metadata["dataset_id"] == "falls/ball-v0");
    CHECK(metadata["minari_version"] == "0.5.0");
    CHECK(metadata["data_format"] == "hdf5");
    CHECK(metadata["total_episodes"] == 6);
    CHECK(metadata["total_steps"] == report["steps"]);
    CHECK(metadata["observation_space"] ==
          R"({"type": "Box", "dtype": "float32", "shape": [6], "low": [-Infinity, -Infinity, -Infinity, -Infinity, )"
          R"(-Infinity, -Infinity], "high": [Infinity, Infinity, Infinity, Infinity, Infinity, Infinity]})");
    // The word is no number; the radius is 0.5 in all runs that are valid.
    CHECK(metadata["action_space"] ==
          R"({"type": "Box", "dtype": "float64", "shape": [2], "low": [1.35, 0.5], "high": [3, 0.5]})");
    CHECK(read_text(data / "main_data.hdf5").starts_with("\x89HDF"));
    CHECK(report["bytes"] == fs::file_size(data / "main_data.hdf5"));
}

TEST_CASE("an episode has the states, the parameters, the measure and the end of its run") {
    const Fall fall;
    REQUIRE(fall.to_minari("sets", {"--reward", "y"}).code == 0);
    const tumble::test::Hdf5Contents file(fall.folder / "sets/falls/ball-v0/data/main_data.hdf5");
    CHECK(file.attribute("episode_4", "run") == 12);  // of 3 m, with the first word
    CHECK(file.attribute("episode_4", "seed") == 7);
    CHECK(file.attribute("episode_4", "options/height") == 3.0);
    CHECK(file.text_attribute("episode_4", "options/word") == "a, \"b\"");
    const double y = file.attribute("episode_4", "measures/y");
    CHECK(file.numbers("episode_4/rewards") == std::vector<double>{0.0, 0.0, y});
    CHECK(read_text(fall.folder / "out/runs.csv").find("," + json(y).dump() + ",") != std::string::npos);
    CHECK(file.numbers("episode_4/actions") == std::vector<double>{3.0, 0.5, 3.0, 0.5, 3.0, 0.5});
    const std::vector<double> seen = file.numbers("episode_4/observations");
    REQUIRE(seen.size() == std::size_t{4} * 6);
    CHECK(seen[1] == 3.0);
    CHECK(seen[18 + 1] == static_cast<float>(y));
    // Of 1.6 m and of 3 m: the scene stops the first.
    CHECK(file.numbers("episode_0/terminations") == std::vector<double>{1});
    CHECK(file.numbers("episode_0/truncations") == std::vector<double>{0});
    CHECK(file.numbers("episode_4/terminations") == std::vector<double>{0, 0, 0});
    CHECK(file.numbers("episode_4/truncations") == std::vector<double>{0, 0, 1});
}

TEST_CASE("the same sweep gives the same dataset, and a dataset is replaced only with --force") {
    const Fall fall;
    REQUIRE(fall.to_minari("one").code == 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 counts times in seconds
    REQUIRE(fall.to_minari("two").code == 0);
    CHECK(are_equal(fall.folder / "one", fall.folder / "two"));
    const Answer again = fall.to_minari("two", {"--reward", "y"});
    CHECK(again.code == 4);
    CHECK_MESSAGE(again.err.find("already exists") != std::string::npos, again.err);
    CHECK(fall.to_minari("two", {"--reward", "y", "--force"}).code == 0);
    CHECK_FALSE(files_of(fall.folder / "one") == files_of(fall.folder / "two"));
    CHECK(fall.to_minari("two", {"--force"}).code == 0);
    CHECK(are_equal(fall.folder / "one", fall.folder / "two"));
}

TEST_CASE("export refuses what gives no dataset, and leaves no file") {
    const Fall fall;
    const auto check = [&](const Answer& answer, int code, const std::string& message) {
        CHECK(answer.code == code);
        CHECK_MESSAGE(answer.err.find(message) != std::string::npos, answer.err);
    };
    check(fall.to_minari("sets", {"--reward", "yy"}), 3,
          "has no column 'yy'; did you mean 'y'?\n  its columns: run, scene, seed, ");
    check(fall.to_minari("sets", {"--reward", "word"}), 3, "runs.csv:6: the reward 'word' is no number: a, \"b\"");
    for (const char* const id : {"ball", "../ball-v0", "/ball-v0", "a b-v0", "x/ball-v0", "ball-v"})
        check(run_tumble({"sweep", "export", fall.at("out"), "-o", fall.at("sets"), "--id", id}), 2,
              "must read NAME-vN");
    const auto export_of = [&](const std::string& name) {
        return run_tumble({"sweep", "export", fall.at(name), "-o", fall.at("sets"), "--id", "ball-v0"});
    };
    check(export_of("gone"), 4, "has no sweep");
    REQUIRE(fall.sweep("part", {"--shard", "0/2"}).code == 0);
    check(export_of("part"), 4, "is not complete");
    const Sweeps without(R"({"format": 1, "scene": "scene.json", "runs": 3, "write": {"trajectory": {"as": "npy"}}})");
    REQUIRE(without.sweep("out").code == 0);
    check(run_tumble({"sweep", "export", without.at("out"), "-o", fall.at("sets"), "--id", "ball-v0"}), 4,
          "has no HDF5 trajectories");
    for (const auto& [name, type] : files_of(fall.folder / "sets")) CHECK(type == "folder");
}

TEST_CASE("NaN and infinities are neither actions nor rewards") {
    const Sweeps sweeps(R"({"format": 1, "scene": "fall.json", "write": {"trajectory": {}}, "parameters": [
      {"name": "height", "set": "/bodies/0/position/1", "list": [2, 3]},
      {"name": "word", "set": "/description", "list": ["nan", "inf"]}],
      "measures": [{"name": "endless", "value": "1 / ball.x"}]})");
    sweeps.folder.write("fall.json", kFallScene);
    REQUIRE(sweeps.sweep("out").code == 0);
    const auto export_with = [&](const std::string& reward) {
        return run_tumble({"sweep", "export", sweeps.at("out"), "-o", sweeps.at("sets"), "--id", "ball-v0", "--force",
                           "--reward", reward});
    };
    REQUIRE(export_with("height").code == 0);
    const json metadata = json::parse(read_text(sweeps.folder / "sets/ball-v0/data/metadata.json"));
    CHECK(metadata["action_space"] == R"({"type": "Box", "dtype": "float64", "shape": [1], "low": [2], "high": [3]})");
    const Answer answer = export_with("endless");
    CHECK(answer.code == 3);
    CHECK_MESSAGE(answer.err.find("the reward 'endless' is no number: inf") != std::string::npos, answer.err);
}

TEST_CASE("export finds a flipped byte in a trajectory or in the table before it writes") {
    const Fall fall;
    for (const char* const name : {"shard-000001.h5", "runs.csv"}) {
        const fs::path file = fall.folder / "out" / name;
        const auto middle = static_cast<std::streamoff>(fs::file_size(file) / 2);
        flip_byte(file, middle);
        const Answer answer = fall.to_minari("sets");
        CHECK(answer.code == 3);
        CHECK_MESSAGE(answer.err.find(std::string(name) + ": its checksum") != std::string::npos, answer.err);
        CHECK(answer.err.find("--check") != std::string::npos);
        CHECK_FALSE(fs::exists(fall.folder / "sets"));
        flip_byte(file, middle);
    }
    CHECK(fall.to_minari("sets").code == 0);
}

TEST_CASE("a full disk ends export with exit code 4, and keeps the dataset that was there") {
    const Fall fall;
    const tumble::test::SmallDisk disk(fall.folder / "disk", 128);
    REQUIRE(fall.to_minari("disk").code == 0);
    fall.folder.write("disk/ballast", std::string(1 << 20, 'x'));  // as much as there is room for
    const auto before = files_of(fall.folder / "disk");
    const Answer answer = fall.to_minari("disk", {"--force", "--reward", "y"});
    CHECK(answer.code == 4);
    CHECK_MESSAGE(answer.err.find("No space left on device") != std::string::npos, answer.err);
    CHECK(files_of(fall.folder / "disk") == before);
}
