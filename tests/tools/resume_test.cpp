// `run --checkpoint` and `run --resume`: a run that was interrupted ends with the bytes of one that was not.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "process.hpp"
#include "tumble/render.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::Process;
using tumble::test::read_text;
using tumble::test::tumble_command;
using tumble::test::wait_for;

namespace {

// The camera follows a body that the timeline spawns, with a trail; others appear all the time.
constexpr const char* kResumed = R"({"format": 1, "world": {"duration": 8}, "camera": {"follow": "car"}, "bodies": [
    {"name": "floor", "type": "static", "position": [0, -1], "shapes": [{"box": {"size": [200, 1]}}]}],
    "timeline": [
      {"at": 0.1, "spawn": {"name": "car", "velocity": [5, 0], "trail": true, "shapes": [{"circle": {"radius": 0.5}}]}},
      {"every": 0.5, "spawn": {"name": "drop", "position": [3, 8], "shapes": [{"box": {"size": [0.6, 0.6]}}]}}]})";

// Run in a folder of its own, with relative paths, so that two runs can have equal settings.
std::vector<std::string> run_of(const Folder& folder, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"run",          (folder / "scene.json").string(),
                                       "-o",           "out",
                                       "--size",       "64x64",
                                       "--trajectory", "tables/t.csv",
                                       "--contacts",   "tables/c.csv",
                                       "--hashes",     "out/h.csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return tumble_command(arguments);
}

// All files below the folder but the summary, by their names.
std::map<std::string, std::string> result_files(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().filename() != "summary.json")
            files[fs::relative(entry.path(), folder).string()] = read_text(entry.path());
    return files;
}

// Two folders: one for the run that is not interrupted.
struct TwoRuns {
    Folder whole, parted;
    std::map<std::string, std::string> expected;

    TwoRuns() {
        whole.write("scene.json", kResumed);
        parted.write("scene.json", kResumed);
        const Answer answer = tumble::test::run(run_of(whole, {}), whole.path());
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        expected = result_files(whole.path());
        REQUIRE(expected.size() > 400);  // 481 frames, and the tables
    }

    // Starts the run or continues it, and sends the signal when the frame exists.
    Answer run_until(const std::string& frame, int signal, std::vector<std::string> more) const {
        more.insert(more.end(), {"--checkpoint", "0"});
        Process process(run_of(parted, more), parted.path());
        wait_for(parted / ("out/frames/frame_" + frame + ".png"), process);
        REQUIRE(process.is_running());
        process.send_signal(signal);
        return process.wait();
    }

    void check_equal() const {
        const std::map<std::string, std::string> found = result_files(parted.path());
        CHECK(found.size() == expected.size());
        for (const auto& file : expected)
            CHECK_MESSAGE((found.contains(file.first) && found.at(file.first) == file.second), file.first);
        const json a = json::parse(read_text(whole / "out/summary.json")),
                   b = json::parse(read_text(parted / "out/summary.json"));
        for (const char* key : {"steps", "state_hash", "files", "view", "complete", "contacts", "bodies", "counters"})
            CHECK_MESSAGE(a[key] == b[key], key);
    }
};

}  // namespace

TEST_CASE("a run that is killed twice and continued has the bytes of one that was not") {
    const TwoRuns runs;
    CHECK(runs.run_until("000060", SIGKILL, {}).code == 128 + SIGKILL);
    CHECK(runs.run_until("000200", SIGKILL, {"--resume"}).code == 128 + SIGKILL);
    const Answer last = tumble::test::run(run_of(runs.parted, {"--resume"}), runs.parted.path());
    CHECK_MESSAGE(last.code == 0, last.err);
    runs.check_equal();
}

TEST_CASE("a run that ends by SIGTERM saves its last step and continues after it") {
    const TwoRuns runs;
    CHECK(runs.run_until("000030", SIGTERM, {}).code == 143);
    CHECK(json::parse(read_text(runs.parted / "out/summary.json"))["complete"] == false);
    CHECK(tumble::test::run(run_of(runs.parted, {"--resume"}), runs.parted.path()).code == 0);
    runs.check_equal();
    CHECK(tumble::test::run(run_of(runs.parted, {"--resume"}), runs.parted.path()).code == 4);  // no checkpoint is left
}

TEST_CASE("--resume refuses another scene, other options, a damaged checkpoint and none") {
    const Folder folder;
    folder.write("scene.json", kResumed);
    const auto run = [&](const std::vector<std::string>& more) {
        return tumble::test::run(run_of(folder, more), folder.path());
    };
    const Answer none = run({"--resume"});
    CHECK(none.code == 4);
    CHECK(none.err.find("no checkpoint") != std::string::npos);
    Process process(run_of(folder, {"--checkpoint", "0", "--force"}), folder.path());
    wait_for(folder / "out/frames/frame_000020.png", process);
    process.send_signal(SIGTERM);
    REQUIRE(process.wait().code == 143);
    CHECK(run({"--resume", "--fps", "30"}).code == 2);
    CHECK(run({"--resume", "--no-frames"}).code == 2);
    CHECK(run({"--resume", "--theme", "dark"}).code == 2);
    CHECK(run({"--resume", "--renderer", "osmesa"}).code == 2);
    const Answer slow = run({"--resume", "--slow", "1:2:0.5"});
    CHECK(slow.code == 2);
    CHECK(slow.err.find("slow 1:2:0.5") != std::string::npos);
    CHECK(run({"--resume", "--force"}).code == 2);
    const Answer other = run({"--resume", "--set", "/world/gravity/1=-9"});
    CHECK(other.code == 3);
    CHECK(other.err.find("another scene") != std::string::npos);
    CHECK(tumble::test::run(
              tumble_command({"run", (folder / "scene.json").string(), "--checkpoint", "1", "--hashes", "-"}),
              folder.path())
              .code == 2);

    const std::string saved = read_text(folder / "out/checkpoint");
    folder.write("out/checkpoint", saved.substr(0, saved.size() / 2));
    CHECK(run({"--resume"}).code == 3);
    folder.write("out/checkpoint", "");
    CHECK(run({"--resume"}).code == 3);
    folder.write("other.txt", "not a table\n");
    std::string elsewhere = saved;
    const std::size_t name = elsewhere.find("\"temporary\":\"") + 13;
    elsewhere.replace(name, elsewhere.find('"', name) - name, "../other.txt");
    folder.write("out/checkpoint", elsewhere);
    const Answer outside = run({"--resume"});
    CHECK(outside.code == 3);
    CHECK(outside.err.find("'../other.txt' is not the name of a file") != std::string::npos);
    CHECK(read_text(folder / "other.txt") == "not a table\n");
    folder.write("out/checkpoint", saved);
    CHECK(run({"--resume"}).code == 0);
}

namespace {

constexpr const char* kPainted = R"({"format": 1, "name": "painted", "world": {"duration": 4},
  "materials": {"ice": {"color": "#8cf"}},
  "camera": {"center": [0, 4], "height": 12, "style": {"outlines": true}, "card": {"title": "Ice", "until": 0.2},
    "notes": [{"text": "crate", "above": "crate"}], "keys": [{"time": 1, "height": 10}, {"time": 2, "height": 8}]},
  "bodies": [{"name": "floor", "type": "static", "position": [0, -1], "shapes": [{"box": {"size": [20, 1]}}]},
    {"name": "crate", "position": [0, 3], "velocity": [1, 0], "images": [{"file": "crate.png", "height": 1}],
      "shapes": [{"box": {"size": [1, 1]}, "material": "ice"}]}],
  "timeline": [{"every": 0.5, "spawn": {"name": "ball", "position": [2, 6], "shapes": [{"circle": {"radius": 0.3}}]}}]})";

// A folder with a run that was interrupted after its 20th frame.
struct Interrupted {
    Folder folder;

    explicit Interrupted(std::vector<std::string> more = {}) {
        folder.write("scene.json", kPainted);
        tumble::write_png({1, 1, {255, 0, 0, 255}}, folder / "crate.png");
        more.insert(more.end(), {"--checkpoint", "0"});
        Process process(run_of(folder, more), folder.path());
        wait_for(folder / "out/frames/frame_000020.png", process);
        process.send_signal(SIGTERM);
        REQUIRE(process.wait().code == 143);
    }

    Answer resume(const std::vector<std::string>& changes) const {
        std::vector<std::string> more{"--resume"};
        for (const std::string& change : changes) more.insert(more.end(), {"--set", change});
        return tumble::test::run(run_of(folder, more), folder.path());
    }
};

}  // namespace

TEST_CASE("--resume refuses a scene whose frames look different") {
    const Interrupted run;
    for (const char* const change :
         {"/name=\"other\"", "/materials/ice/color=\"#8cd\"", "/camera/height=13", "/camera/center/0=1",
          "/camera/style/theme=\"dark\"", "/camera/style/outlines=false", "/camera/style/hatching=true",
          "/camera/style/shadows=true", "/camera/card/title=\"Snow\"", "/camera/notes/0/text=\"box\"",
          "/camera/keys/1/height=9", "/bodies/crate/trail=true", "/bodies/crate/images/0/height=1.5",
          "/bodies/crate/images/0/file=\"other.png\"", "/timeline/0/spawn/trail=true",
          "/timeline/0/spawn/images=[{\"file\": \"crate.png\", \"height\": 1}]"}) {
        const Answer changed = run.resume({change});
        CHECK_MESSAGE(changed.code == 3, change);
        CHECK_MESSAGE(changed.err.find("checkpoint: the frames before it look different") != std::string::npos,
                      changed.err);
    }
    tumble::write_png({1, 1, {255, 1, 0, 255}}, run.folder / "crate.png");
    CHECK(run.resume({}).code == 3);
    fs::remove(run.folder / "crate.png");
    CHECK(run.resume({}).code == 3);
    tumble::write_png({1, 1, {255, 0, 0, 255}}, run.folder / "crate.png");
    fs::resize_file(run.folder / "crate.png", (std::uintmax_t{1} << 29) + 1);
    const Answer large = run.resume({});
    CHECK(large.code == 3);
    CHECK_MESSAGE(large.err.find("crate.png: the picture is too large") != std::string::npos, large.err);
    tumble::write_png({1, 1, {255, 0, 0, 255}}, run.folder / "crate.png");
    CHECK(run.resume({}).code == 0);
}

TEST_CASE("--resume accepts other claims, remarks and a longer duration, and ends with the frames of the new scene") {
    const std::vector<std::string> changes{"/expect=[{\"max_penetration\": 0.1}]", "/description=\"ice\"",
                                           "/bodies/crate/custom={\"a\": 1}", "/world/duration=5"};
    const Interrupted run;
    const Answer resumed = run.resume(changes);
    CHECK_MESSAGE(resumed.code == 0, resumed.err);
    const Folder whole;
    whole.write("scene.json", kPainted);
    tumble::write_png({1, 1, {255, 0, 0, 255}}, whole / "crate.png");
    std::vector<std::string> more;
    for (const std::string& change : changes) more.insert(more.end(), {"--set", change});
    REQUIRE(tumble::test::run(run_of(whole, more), whole.path()).code == 0);
    REQUIRE(fs::exists(whole / "out/frames/frame_000300.png"));
    CHECK(result_files(run.folder.path()) == result_files(whole.path()));
}

TEST_CASE("--resume refuses a duration of the scene that changes the fitted view, and accepts --duration") {
    const std::vector<std::string> fitted{"/camera={}"};
    const Interrupted run({"--set", fitted.front()});
    CHECK(run.resume({fitted.front(), "/world/duration=9"}).code == 3);
    std::vector<std::string> more{"--resume", "--set", fitted.front(), "--duration", "5"};
    CHECK(tumble::test::run(run_of(run.folder, more), run.folder.path()).code == 0);
}

TEST_CASE("without frames --resume accepts a scene that looks different") {
    const Folder folder;
    folder.write("scene.json", kPainted);
    const auto arguments = [&](std::vector<std::string> more) {
        more.insert(more.end(), {"--no-frames", "--duration", "1000"});
        return run_of(folder, more);
    };
    Process process(arguments({"--checkpoint", "0"}), folder.path());
    wait_for(folder / "out/checkpoint", process);
    process.send_signal(SIGTERM);
    REQUIRE(process.wait().code == 143);
    const double time = json::parse(read_text(folder / "out/summary.json"))["steps"].get<double>() / 60.0;
    CHECK(tumble::test::run(
              tumble_command({"run", (folder / "scene.json").string(), "-o", "out", "--no-frames", "--resume",
                              "--duration", std::to_string(time + 1.0), "--set", "/materials/ice/color=\"#fff\"",
                              "--trajectory", "tables/t.csv", "--contacts", "tables/c.csv", "--hashes", "out/h.csv"}),
              folder.path())
              .code == 0);
}

TEST_CASE("--resume refuses a table that was changed, and continues one that was restored") {
    const TwoRuns runs;
    const auto resume = [&] { return tumble::test::run(run_of(runs.parted, {"--resume"}), runs.parted.path()); };
    CHECK(runs.run_until("000060", SIGTERM, {}).code == 143);
    const std::string table = read_text(runs.parted / "tables/t.csv");
    std::string edited = table;
    edited[edited.size() / 2] ^= 1;
    runs.parted.write("tables/t.csv", edited);
    const Answer refused = resume();
    CHECK(refused.code == 3);
    CHECK_MESSAGE(refused.err.find("tables/t.csv: is not the table of the interrupted run") != std::string::npos,
                  refused.err);
    CHECK(read_text(runs.parted / "tables/t.csv") == edited);
    runs.parted.write("tables/t.csv", table.substr(0, table.size() - 1));
    CHECK(resume().code == 3);
    fs::remove(runs.parted / "tables/t.csv");
    CHECK(resume().code == 4);
    // A table that another run has left under the name that a continued run uses for a while.
    runs.parted.write("tables/t.csv.earlier", edited);
    runs.parted.write("tables/t.csv", table);
    CHECK(resume().code == 0);
    runs.check_equal();
}

TEST_CASE("a killed run continues after its folders have moved") {
    const TwoRuns runs;
    CHECK(runs.run_until("000060", SIGKILL, {}).code == 128 + SIGKILL);
    fs::rename(runs.parted / "out", runs.parted / "moved");
    fs::rename(runs.parted / "tables", runs.parted / "moved/tables");
    std::vector<std::string> arguments = run_of(runs.parted, {"--resume"});
    for (std::string& argument : arguments) {
        if (argument == "out") argument = (runs.parted / "moved").string();
        if (argument.starts_with("tables/")) argument = "moved/" + argument;
        if (argument == "out/h.csv") argument = "moved/h.csv";
    }
    const Answer answer = tumble::test::run(arguments, runs.parted.path());
    CHECK_MESSAGE(answer.code == 0, answer.err);
    fs::rename(runs.parted / "moved/tables", runs.parted / "tables");
    fs::rename(runs.parted / "moved", runs.parted / "out");
    for (const auto& file : result_files(runs.parted.path()))
        CHECK_MESSAGE((runs.expected.contains(file.first) && runs.expected.at(file.first) == file.second), file.first);
}

TEST_CASE("--resume refuses a duration that ends before the checkpoint, and changes nothing") {
    const TwoRuns runs;
    CHECK(runs.run_until("000060", SIGTERM, {}).code == 143);
    const std::map<std::string, std::string> before = result_files(runs.parted.path());
    const Answer shorter =
        tumble::test::run(run_of(runs.parted, {"--resume", "--duration", "0.5"}), runs.parted.path());
    CHECK(shorter.code == 2);
    CHECK_MESSAGE(shorter.err.find("--duration: ends before the checkpoint, which is at ") != std::string::npos,
                  shorter.err);
    CHECK(result_files(runs.parted.path()) == before);
    CHECK(tumble::test::run(run_of(runs.parted, {"--resume"}), runs.parted.path()).code == 0);
    runs.check_equal();
}

TEST_CASE("--resume says that the duration of the scene ends before the checkpoint, if there is no --duration") {
    const Interrupted run;
    const std::string shorter = "/world/duration=0.2";
    const Answer scene = run.resume({shorter});
    CHECK(scene.code == 3);
    CHECK_MESSAGE(
        scene.err.find("checkpoint: the \"duration\" of the scene ends before the checkpoint, which is at ") !=
            std::string::npos,
        scene.err);
    CHECK(scene.err.find("--duration: ") == std::string::npos);
    CHECK(tumble::test::run(run_of(run.folder, {"--resume", "--set", shorter, "--duration", "4"}), run.folder.path())
              .code == 0);
}

TEST_CASE("an output file with the name of the checkpoint, of a frame or of another output is refused") {
    const Folder folder;
    folder.write("scene.json", kResumed);
    fs::create_directory(folder / "out");
    fs::create_directory_symlink(folder / "out", folder / "link");
    for (const char* const file : {"out/checkpoint", "out/./summary.json", "link/checkpoint", "link/events.csv",
                                   "out/frames/frame_000007.png", "t.csv"}) {
        CAPTURE(file);
        const std::vector<std::string> arguments{"run",        "scene.json", "-o",           "out",
                                                 "--duration", "0.1",        "--trajectory", "t.csv",
                                                 "--hashes",   file,         "--size",       "64x64"};
        CHECK(tumble::test::run(tumble_command(arguments), folder.path()).code == 2);
    }
    CHECK(fs::is_empty(folder / "out"));
}
