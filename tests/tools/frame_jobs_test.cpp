// Frames that are drawn on several threads.
#include <doctest/doctest.h>

#include <cstddef>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "process.hpp"

namespace fs = std::filesystem;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::read_text;
using tumble::test::run_tumble;

namespace {

const std::string kCatapult = TUMBLE_SOURCE_DIR "/scenes/catapult.json";

// A catapult has trails, and a stone that leaves it. The overlay shows contacts, islands and joints too.
std::vector<std::string> catapult(const fs::path& folder, const std::string& jobs, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"run", kCatapult, "-o", folder.string(), "--size", "160x90", "--fps",
                                       "12",  "--jobs",  jobs, "--overlay",     "all"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

// Its speed is no float after half a second.
constexpr const char* kDivergingMote =
    R"({"format": 1, "name": "mote", "world": {"duration": 1, "gravity": [0, 0]}, "bodies": [
            {"name": "mote", "mass": {"mass": 1e-30, "inertia": 0}, "shapes": [{"circle": {"radius": 0.5}}]}],
            "timeline": [{"at": 0.5, "body": "mote", "impulse": [1e12, 0]}]})";

}  // namespace

TEST_CASE("frames and raw videos have the same bytes for each number of drawing threads") {
    const Folder folder;
    for (const std::string jobs : {"1", "2", "5"}) {
        const std::string raw = (folder / ("raw" + jobs)).string();
        const Answer answer = run_tumble(catapult(folder / jobs, jobs, {"--raw-video", raw}));
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
    }
    std::size_t frames = 0;
    for (const fs::directory_entry& frame : fs::directory_iterator(folder / "1/frames")) {
        CAPTURE(frame.path().filename().string());
        const std::string png = read_text(frame.path());
        for (const std::string jobs : {"2", "5"})
            CHECK(read_text(folder / jobs / "frames" / frame.path().filename()) == png);
        ++frames;
    }
    CHECK(frames > 12);
    CHECK(read_text(folder / "raw1").size() == frames * 160 * 90 * 3);
    for (const std::string jobs : {"2", "5"}) CHECK(read_text(folder / ("raw" + jobs)) == read_text(folder / "raw1"));
}

TEST_CASE("a run of several drawing threads continues from its checkpoint with the same frames") {
    const Folder folder;
    REQUIRE(run_tumble(catapult(folder / "whole", "1")).code == 0);
    tumble::test::Process process(tumble::test::tumble_command(catapult(folder / "parts", "3", {"--checkpoint", "0"})));
    tumble::test::wait_for(folder / "parts/frames/frame_000004.png", process);
    process.send_signal(2);
    const int code = process.wait().code;
    CHECK((code == 130 || code == 0));  // a fast machine may complete the run first
    if (code == 130) REQUIRE(run_tumble(catapult(folder / "parts", "3", {"--resume"})).code == 0);
    for (const fs::directory_entry& frame : fs::directory_iterator(folder / "whole/frames"))
        CHECK(read_text(folder / "parts/frames" / frame.path().filename()) == read_text(frame.path()));
}

TEST_CASE("a run that diverges leaves the frames before, on one drawing thread and on several") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kDivergingMote);
    std::vector<std::ptrdiff_t> frames;
    for (const std::string jobs : {"1", "5"}) {
        const std::string out = (folder / jobs).string();
        CHECK(run_tumble({"run", scene, "-o", out, "--size", "64x36", "--jobs", jobs}).code == 6);
        frames.push_back(std::distance(fs::directory_iterator(folder / jobs / "frames"), {}));
    }
    CHECK(frames[0] > 29);
    CHECK(frames[1] == frames[0]);
}

TEST_CASE("a run that diverges completes the video of the frames before") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kDivergingMote);
    const fs::path video = folder / "mote.gif";
    CHECK(run_tumble({"run", scene, "-o", (folder / "out").string(), "--size", "64x36", "--no-frames", "--video",
                      video.string(), "--fps", "20"})
              .code == 6);
    CHECK(fs::exists(video));
}

TEST_CASE("drawing threads that cannot draw leave the results of an earlier run") {
    const Folder folder;
    for (const char* const name : {"libOSMesa.so.8", "libOSMesa.so", "libEGL.so.1", "libEGL.so"})
        folder.write(name, "no library");
    const fs::path out = folder / "out";
    REQUIRE(run_tumble({"run", kCatapult, "-o", out.string(), "--no-frames", "--duration", "0.1"}).code == 0);
    const std::string summary = read_text(out / "summary.json");
    std::vector<std::string> command = tumble::test::tumble_command(catapult(out, "3", {"--force"}));
    command.insert(command.begin(), {"/usr/bin/env", "LD_LIBRARY_PATH=" + folder.path().string()});
    const Answer answer = tumble::test::run(command);
    CHECK_MESSAGE(answer.code == 5, answer.err);
    CHECK(read_text(out / "summary.json") == summary);
    CHECK(run_tumble(catapult(folder / "none", "0")).code == 2);
}
