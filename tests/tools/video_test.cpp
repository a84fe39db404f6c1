// Videos of runs: what ffprobe and the frames say of them, and how failures end.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "process.hpp"
#include "support/near.hpp"
#include "support/small_disk.hpp"
#include "video_probe.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::absolute;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::near;
using tumble::test::number_in;
using tumble::test::probe;
using tumble::test::Process;
using tumble::test::read_text;
using tumble::test::run_tumble;
using tumble::test::wait_for_encoder;

namespace {

std::vector<std::string> arguments_of(const Folder& folder, const std::string& video,
                                      const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"run",     folder.write("small.json", tumble::test::small_scene()),
                                       "-o",      (folder / "out").string(),
                                       "--video", (folder / video).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

// The lowest signal-to-noise ratio (dB) of a frame of the video against the PNG file of that frame, of `frames` frames,
// both in the form that the filters give them.
double lowest_psnr_as(const Folder& folder, const std::string& video, const std::string& fps, int frames,
                      const std::string& png_filter, const std::string& video_filter) {
    const fs::path statistics = folder / "psnr.txt";
    const Answer answer =
        tumble::test::run({"ffmpeg", "-v", "error", "-framerate", fps, "-i",
                           (folder / "out/frames/frame_%06d.png").string(), "-i", (folder / video).string(), "-lavfi",
                           "[0]" + png_filter + ",setpts=N/TB[a];[1]" + video_filter +
                               ",setpts=N/TB[b];[a][b]psnr=stats_file=" + statistics.string(),
                           "-f", "null", "-"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    double lowest = std::numeric_limits<double>::infinity();  // of equal frames
    int compared = 0;
    const std::string text = read_text(statistics), key = "psnr_avg:";
    for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
        const std::string value = text.substr(at + key.size(), 8);
        lowest = std::min(lowest, std::stod(value));  // reads "inf" too
        ++compared;
    }
    CHECK(compared == frames);
    return lowest;
}

double lowest_psnr(const Folder& folder, const std::string& video, const std::string& fps, int frames) {
    return lowest_psnr_as(folder, video, fps, frames, "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
                          "format=yuv420p");
}

// Of the colours themselves, at 10 frames per second.
double lowest_psnr_rgb(const Folder& folder, const std::string& video, int frames) {
    return lowest_psnr_as(folder, video, "10", frames, "format=rgb24", "format=rgb24");
}

bool has_partial_file(const fs::path& folder) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".partial") return true;
    return false;
}

const std::vector<std::string> kLong{"--no-frames", "--duration", "100000", "--size", "320x180"};

}  // namespace

TEST_CASE("MP4 and WebM have the frames of the run, their exact duration, and tagged colours") {
    for (const std::string name : {"run.mp4", "run.webm"}) {
        CAPTURE(name);
        const Folder folder;
        const Answer answer =
            run_tumble(arguments_of(folder, name, {"--duration", "1.5", "--fps", "30", "--size", "320x180", "--json"}));
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        const json found = probe(folder / name), stream = found["streams"].at(0);
        CHECK(stream["codec_name"] == (name == "run.mp4" ? "h264" : "vp9"));
        CHECK(stream["nb_read_frames"] == "46");  // 1.5 x 30 + 1
        CHECK(stream["r_frame_rate"] == "30/1");
        CHECK(stream["avg_frame_rate"] == "30/1");
        CHECK(near(number_in(found["format"]["duration"]), 46.0 / 30.0, absolute(1e-3)));
        CHECK(stream["pix_fmt"] == "yuv420p");
        CHECK(stream["color_range"] == "tv");
        for (const char* key : {"color_space", "color_transfer", "color_primaries"}) CHECK(stream[key] == "bt709");
        CHECK(lowest_psnr(folder, name, "30", 46) > 38.0);
        const json summary = json::parse(answer.out);
        CHECK(summary["files"][1]["kind"] == "video");
        CHECK(summary["files"][1]["bytes"] == fs::file_size(folder / name));
        CHECK(!has_partial_file(folder.path()));
    }
}

TEST_CASE("GIF and APNG have the duration of the run, without PNG files") {
    for (const std::string name : {"run.gif", "run.apng"}) {
        CAPTURE(name);
        const Folder folder;
        const Answer answer = run_tumble(
            arguments_of(folder, name, {"--duration", "1", "--fps", "25", "--size", "161x91", "--no-frames"}));
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        const json stream = probe(folder / name)["streams"].at(0);
        CHECK(stream["nb_read_frames"] == "26");
        CHECK(stream["width"] == 161);
        CHECK(stream["r_frame_rate"] == "25/1");
        CHECK(!fs::exists(folder / "out/frames"));
    }
}

TEST_CASE("an APNG has the pixels of the frames, and a GIF those of its palette") {
    for (const std::string name : {"run.gif", "run.apng"}) {
        CAPTURE(name);
        const Folder folder;
        const Answer answer =
            run_tumble(arguments_of(folder, name, {"--duration", "0.4", "--fps", "10", "--size", "160x90"}));
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        const double lowest = lowest_psnr_rgb(folder, name, 5);
        // The frames have few colours apart from smooth edges: 256 of them leave errors of a few levels. 255 / 5 is
        // 34 dB.
        if (name == "run.gif") CHECK(lowest > 34.0);
        if (name == "run.apng") CHECK(lowest == std::numeric_limits<double>::infinity());
        // Browsers repeat both: the block of Netscape with 0 repetitions, and the chunk acTL with 0 plays.
        const std::string bytes = read_text(folder / name);
        const std::string netscape("NETSCAPE2.0\x03\x01\0\0", 15);
        if (name == "run.gif") CHECK(bytes.find(netscape) != std::string::npos);
        if (name == "run.apng") CHECK(bytes.substr(bytes.find("acTL") + 4, 8) == std::string("\0\0\0\x05\0\0\0\0", 8));
    }
}

TEST_CASE("a GIF leaves out frames above 50 a second, and keeps its duration") {
    const Folder folder;
    REQUIRE(run_tumble(
                arguments_of(folder, "run.gif", {"--duration", "1", "--fps", "60", "--size", "160x90", "--no-frames"}))
                .code == 0);
    const json found = probe(folder / "run.gif");
    // 61 frames last 61/60 s, in which a rate of 50 has 50.8 frames: ffmpeg rounds to 51, which last 1.02 s.
    CHECK(found["streams"][0]["nb_read_frames"] == "51");
    CHECK(found["format"]["duration"] == "1.020000");
}

TEST_CASE("slow motion makes a video longer, and is repeatable, in order and without overlap") {
    const Folder folder;
    const std::vector<std::string> small{"--no-frames", "--duration", "1", "--fps", "30", "--size", "64x36", "--force"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.end(), small.begin(), small.end());
        return arguments_of(folder, "run.mp4", more);
    };
    const Answer answer = run_tumble(with({"--slow", "0.6:0.7:0.5", "--slow", "0.2:0.3:0.25"}));
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    // 1 s, of which 0.1 s are 0.2 s on screen and 0.1 s are 0.4 s: 1.4 s, 43 frames.
    CHECK(probe(folder / "run.mp4")["streams"][0]["nb_read_frames"] == "43");
    CHECK(answer.err.find("too few steps per second") != std::string::npos);  // 60 x 0.25 < 30
    for (const std::string wrong : {"1", "1:2", "1:2:0", "2:1:0.5", "1:2:3", "1:2:0.5x", "-1:2:0.5", "1:2:nan"}) {
        CAPTURE(wrong);
        CHECK(run_tumble(with({"--slow=" + wrong})).code == 2);
    }
    CHECK(run_tumble(with({"--slow", "0.2:0.5:0.5", "--slow", "0.4:0.6:0.5"})).code == 2);
}

TEST_CASE("one processor and several give the same bytes") {
    const Folder folder;
    const std::vector<std::string> more{"--duration", "1", "--size", "320x180", "--no-frames", "--force"};
    for (const std::string extension : {".mp4", ".webm"}) {
        CAPTURE(extension);
        REQUIRE(run_tumble(arguments_of(folder, "a" + extension, more)).code == 0);
        std::vector<std::string> alone = tumble::test::tumble_command(arguments_of(folder, "b" + extension, more));
        alone.insert(alone.begin(), {"taskset", "1"});
        REQUIRE(tumble::test::run(alone).code == 0);
        CHECK(read_text(folder / ("a" + extension)) == read_text(folder / ("b" + extension)));
    }
}

TEST_CASE("Ctrl-C leaves a video of the frames done, and exit code 130") {
    const Folder folder;
    Process process(tumble::test::tumble_command(arguments_of(folder, "run.mp4", kLong)));
    const int encoder = wait_for_encoder(folder / "run.mp4", process);
    REQUIRE(encoder > 0);
    REQUIRE(tumble::test::wait_for_frames(encoder, 1'000'000));
    process.send_signal(SIGINT);
    const Answer answer = process.wait();
    CHECK_MESSAGE(answer.code == 130, answer.err);
    const json summary = json::parse(read_text(folder / "out/summary.json"));
    CHECK(summary["complete"] == false);
    CHECK(number_in(probe(folder / "run.mp4")["streams"][0]["nb_read_frames"]) == summary["steps"].get<double>() + 1.0);
    CHECK(!has_partial_file(folder.path()));
}

TEST_CASE("an encoder that is killed ends the run with exit code 5 and without a video") {
    const Folder folder;
    Process process(tumble::test::tumble_command(arguments_of(folder, "run.mp4", kLong)));
    const int encoder = wait_for_encoder(folder / "run.mp4", process);
    REQUIRE(encoder > 0);
    kill(encoder, SIGKILL);
    const Answer answer = process.wait();
    CHECK(answer.code == 5);
    CHECK_MESSAGE(answer.err.find("ffmpeg was ended by signal 9") != std::string::npos, answer.err);
    CHECK(!fs::exists(folder / "run.mp4"));
    CHECK(!has_partial_file(folder.path()));
}

TEST_CASE("without ffmpeg, --video ends with exit code 5 and says what to install") {
    const Folder folder;
    std::vector<std::string> command = tumble::test::tumble_command(arguments_of(folder, "run.mp4", {"--no-frames"}));
    command.insert(command.begin(), {"env", "PATH=" + folder.path().string()});
    const Answer answer = tumble::test::run(command);
    CHECK(answer.code == 5);
    CHECK_MESSAGE(answer.err.find("apt-get install") != std::string::npos, answer.err);
    CHECK(!fs::exists(folder / "run.mp4"));
    CHECK(!has_partial_file(folder.path()));
    // With --force, the results of an earlier run stay.
    REQUIRE(run_tumble({"run", (folder / "small.json").string(), "-o", (folder / "out").string(), "--no-frames",
                        "--force", "--duration", "0.1"})
                .code == 0);
    const std::string summary = read_text(folder / "out/summary.json");
    command.push_back("--force");
    CHECK(tumble::test::run(command).code == 5);
    CHECK(read_text(folder / "out/summary.json") == summary);
    std::vector<std::string> without =
        tumble::test::tumble_command({"run", (folder / "small.json").string(), "-o", (folder / "png").string(),
                                      "--duration", "0.1", "--size", "64x36"});
    without.insert(without.begin(), {"env", "PATH=" + folder.path().string()});
    CHECK(tumble::test::run(without).code == 0);
}

TEST_CASE("a full disk ends a video with exit code 4 and leaves no partial file") {
    const Folder folder;
    const tumble::test::SmallDisk disk(folder / "disk", 32);
    for (const std::string name : {"run.mp4", "run.webm", "run.gif"}) {
        CAPTURE(name);
        const Answer answer = run_tumble(
            arguments_of(folder, "disk/" + name, {"--no-frames", "--force", "--duration", "5", "--size", "640x360"}));
        CHECK_MESSAGE(answer.code == 4, answer.err);
        CHECK_MESSAGE(answer.err.find("No space left on device") != std::string::npos, answer.err);
        CHECK(fs::is_empty(folder / "disk"));
    }
}

TEST_CASE("videos that cannot be made are refused before the first step") {
    const Folder folder;
    const auto code_of = [&folder](const std::string& name, const std::vector<std::string>& more) {
        const int code = run_tumble(arguments_of(folder, name, more)).code;
        CHECK(!fs::exists(folder / "out"));
        return code;
    };
    CHECK(code_of("run.avi", {}) == 2);
    CHECK(code_of("run", {}) == 2);
    CHECK(code_of("run.mp4", {"--size", "321x180"}) == 2);
    CHECK(code_of("run.gif", {"--duration", "1000"}) == 2);
    folder.write("mine.mp4", "mine");
    CHECK(code_of("mine.mp4", {}) == 4);
    CHECK(read_text(folder / "mine.mp4") == "mine");
}

TEST_CASE("a video on standard output is an MP4 that plays from the start, with all frames") {
    const Folder folder;
    std::vector<std::string> arguments =
        arguments_of(folder, "", {"--no-frames", "--duration", "1", "--fps", "30", "--size", "64x48"});
    arguments[5] = "-";
    const Answer answer = run_tumble(arguments);
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const fs::path file = folder / "piped.mp4";
    folder.write("piped.mp4", answer.out);
    const json found = probe(file);
    CHECK(found["streams"][0]["codec_name"] == "h264");
    CHECK(found["streams"][0]["nb_read_frames"] == "31");
    // An MP4 with an index has it in one piece; one of fragments has an empty one before the first fragment.
    CHECK(answer.out.find("moov") < answer.out.find("moof"));
    CHECK(answer.out.find("moof") < answer.out.find("mdat"));
    const json summary = json::parse(read_text(folder / "out/summary.json"));
    CHECK(summary["files"][0]["bytes"] == answer.out.size());
    arguments.insert(arguments.end(), {"--force", "--hashes", "-"});
    CHECK(run_tumble(arguments).code == 2);
}

TEST_CASE("a reader that closes the pipe of a video ends the run with exit code 4") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    const Answer answer = tumble::test::run({"/bin/bash", "-c",
                                             "set -o pipefail; " TUMBLE_BINARY " run " + scene +
                                                 " --no-frames --duration 1000 --size 64x48 -o " +
                                                 (folder / "out").string() + " --video - | head -c 100 > /dev/null"});
    CHECK(answer.code == 4);
    CHECK(answer.err.find("Broken pipe") != std::string::npos);
}
