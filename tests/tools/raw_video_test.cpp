// `run --raw-video`: frames without compression, for other programs.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <vector>

#include "process.hpp"
#include "tumble/render.hpp"

using nlohmann::json;
using tumble::Image;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::read_text;
using tumble::test::run_tumble;

namespace {

constexpr std::size_t kWidth = 64, kHeight = 48, kFrameBytes = 3 * kWidth * kHeight;

// 0.1 s at 30 frames/s: 4 frames.
std::vector<std::string> arguments(const std::string& out, std::vector<std::string> more) {
    const std::string scene = TUMBLE_SOURCE_DIR "/scenes/pendulum.json";
    std::vector<std::string> all{"run", scene, "-o", out, "--duration", "0.1", "--fps", "30", "--size", "64x48"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

// The pixels of a frame as the PNG file has them, without alpha.
std::string pixels_of(const std::filesystem::path& png) {
    const Image image = tumble::read_png(png);
    std::string bytes;
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
        if (i % 4 != 3) bytes += static_cast<char>(image.rgba[i]);
    return bytes;
}

}  // namespace

TEST_CASE("raw frames on standard output are the pixels of the PNG files, and nothing else") {
    const Folder folder;
    const Answer answer = run_tumble(arguments((folder / "out").string(), {"--raw-video", "-"}));
    CHECK(answer.code == 0);
    REQUIRE(answer.out.size() == 4 * kFrameBytes);
    for (std::size_t frame = 0; frame < 4; ++frame) {
        const std::string png = "out/frames/frame_00000" + std::to_string(frame) + ".png";
        CHECK(answer.out.substr(frame * kFrameBytes, kFrameBytes) == pixels_of(folder / png));
    }
    CHECK(answer.out.substr(0, kFrameBytes) != answer.out.substr(3 * kFrameBytes));  // the pendulum moves
    CHECK(answer.err.find("frames") != std::string::npos);                           // the report of the run
}

TEST_CASE("raw frames are drawn without PNG files too, into a file that the summary lists") {
    const Folder folder;
    const std::string out = (folder / "out").string(), raw = (folder / "raw/frames.rgb").string();
    const Answer answer = run_tumble(arguments(out, {"--raw-video", raw, "--no-frames", "--json"}));
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(answer.err.empty());
    CHECK(read_text(raw).size() == 4 * kFrameBytes);
    const json files = json::parse(answer.out)["files"];
    CHECK(files[0]["kind"] == "raw video");
    CHECK(files[0]["bytes"] == 4 * kFrameBytes);
    CHECK_FALSE(std::filesystem::exists(folder / "out/frames"));
    CHECK(run_tumble(arguments(out, {"--raw-video", raw, "--no-frames"})).code == 4);
    CHECK(run_tumble(arguments(out, {"--raw-video", raw, "--no-frames", "--force"})).code == 0);
}

TEST_CASE("raw frames do not share a file, and are no part of checkpoints") {
    const Folder folder;
    const std::string out = (folder / "out").string();
    CHECK(run_tumble(arguments(out, {"--raw-video", "-", "--hashes", "-"})).code == 2);
    CHECK(
        run_tumble(arguments(out, {"--raw-video", (folder / "a").string(), "--video", (folder / "a").string()})).code ==
        2);
    CHECK(run_tumble(arguments(out, {"--raw-video", "-", "--checkpoint", "0"})).code == 2);
}

TEST_CASE("a reader that goes away ends a run of raw frames with exit code 4") {
    const Folder folder;
    const std::string command = tumble::test::tumble_command({})[0] +
                                " run " TUMBLE_SOURCE_DIR "/scenes/pendulum.json -o " + (folder / "out").string() +
                                " --no-frames --size 640x360 --raw-video - 2> /dev/null | head -c 100 > /dev/null; "
                                "echo ${PIPESTATUS[0]}";
    CHECK(tumble::test::Process({"bash", "-c", command}, ".").wait().out == "4\n");
}
