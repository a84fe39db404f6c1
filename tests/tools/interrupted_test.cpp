// Runs that end early, by a signal or a full disk, leave only complete files.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "process.hpp"
#include "support/small_disk.hpp"

namespace fs = std::filesystem;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::Process;
using tumble::test::read_text;
using tumble::test::wait_for;

namespace {

// Every PNG ends with the same 12 bytes: an empty chunk IEND and its checksum.
bool is_whole_png(const fs::path& file) {
    const std::string end("\0\0\0\0IEND\xae\x42\x60\x82", 12);
    const std::string bytes = read_text(file);
    return bytes.starts_with("\x89PNG") && bytes.ends_with(end);
}

// Checks that the folder contains complete frames and no temporary file. Returns the number of frames.
int check_frames(const fs::path& folder) {
    int frames = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        CAPTURE(entry.path().string());
        CHECK(is_whole_png(entry.path()));
        ++frames;
    }
    return frames;
}

void check_interruption(int signal, int code) {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    const fs::path out = folder / "out";
    Process process(tumble::test::tumble_command({"run", scene, "--duration", "100000", "--size", "320x180", "-o",
                                                  out.string(), "--hashes", (folder / "hashes.csv").string()}));
    wait_for(out / "frames/frame_000003.png", process);
    process.send_signal(signal);
    const Answer answer = process.wait();
    CHECK_MESSAGE(answer.code == code, answer.err);
    const nlohmann::json summary = nlohmann::json::parse(read_text(out / "summary.json"));
    CHECK(summary["complete"] == false);
    CHECK(check_frames(out / "frames") == summary["files"][0]["count"].get<int>());
    // One line per step, one for the initial state, and the header.
    const std::string hashes = read_text(folder / "hashes.csv");
    CHECK(std::count(hashes.begin(), hashes.end(), '\n') == summary["steps"].get<int>() + 2);
}

}  // namespace

TEST_CASE("Ctrl-C finishes the current frame, and the summary is not complete") {
    check_interruption(SIGINT, 130);
    check_interruption(SIGHUP, 130);
    check_interruption(SIGTERM, 143);
}

TEST_CASE("a run that was started to ignore SIGHUP ignores it") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    std::vector<std::string> command = tumble::test::tumble_command(
        {"run", scene, "--duration", "100000", "--size", "320x180", "-o", (folder / "out").string()});
    command.insert(command.begin(), "nohup");
    Process process(command, folder.path());
    wait_for(folder / "out/frames/frame_000003.png", process);
    process.send_signal(SIGHUP);
    wait_for(folder / "out/frames/frame_000020.png", process);
    CHECK(fs::exists(folder / "out/frames/frame_000020.png"));
    CHECK(process.is_running());
    process.send_signal(SIGTERM);
    CHECK(process.wait().code == 143);
}

TEST_CASE("check ends with 143 after SIGTERM") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    const fs::path junit = folder / "junit.xml";
    // A claim on the end is neither true nor false before it.
    const std::vector<std::string> command =
        tumble::test::tumble_command({"check", scene, "--set", "/world/duration=100000", "--set",
                                      R"(/expect=[{"that": "false"}])", "--junit", junit.string()});
    Answer answer;
    // A signal that comes before the first step leaves no answer: the next check waits longer for it.
    for (int i = 1; i <= 10 && answer.out.empty(); ++i) {
        Process process(command);
        std::this_thread::sleep_for(std::chrono::milliseconds(500 * i));
        process.send_signal(SIGTERM);
        answer = process.wait();
        CHECK(answer.code == 143);
    }
    CHECK(answer.out.find("interrupted at step") != std::string::npos);
    CHECK(answer.out.find("failed") == std::string::npos);
    CHECK(tumble::test::read_text(junit).find(R"(tests="1" failures="0" errors="1")") != std::string::npos);
}

TEST_CASE("a second run into the folder of a running one is refused, and a killed one leaves nothing that blocks") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    const fs::path out = folder / "out", tables = folder / "tables";
    const std::vector<std::string> run{"run",     scene,        "--size",       "320x180",
                                       "-o",      out.string(), "--trajectory", (tables / "t.csv").string(),
                                       "--force", "--duration"};
    const auto lasting = [&run](const std::string& duration) {
        std::vector<std::string> arguments = run;
        arguments.push_back(duration);
        return tumble::test::tumble_command(arguments);
    };
    Process first(lasting("100000"));
    wait_for(out / "frames/frame_000003.png", first);
    const Answer second = tumble::test::run(lasting("0.1"));
    CHECK(second.code == 4);
    CHECK_MESSAGE(second.err.find("process " + std::to_string(first.id()) + " (") != std::string::npos, second.err);
    CHECK(first.is_running());

    first.send_signal(SIGKILL);
    CHECK(first.wait().code == 128 + SIGKILL);
    const auto partial_count = [&] {
        int count = 0;
        for (const fs::path& place : {out, tables})
            for (const fs::directory_entry& entry : fs::recursive_directory_iterator(place))
                if (entry.path().extension() == ".partial") ++count;
        return count;
    };
    CHECK(partial_count() >= 3);  // summary, events, trajectory, and frames that were being written
    std::vector<std::string> unforced = lasting("0.1");
    std::erase(unforced, "--force");
    CHECK(tumble::test::run(unforced).code == 4);
    const std::string of_another = folder.write("tables/notes.1-0.partial", "");
    folder.write("out/old.csv." + std::to_string(first.id()) + "-9.partial", "");  // a table that is not named again
    folder.write("tables/t.csv.1-0.partial", "");  // as of a killed process whose number another has now
    CHECK(tumble::test::run(lasting("0.1")).code == 0);
    CHECK(partial_count() == 1);  // not of this run
    CHECK(fs::exists(of_another));
    CHECK(check_frames(out / "frames") == 7);
}

TEST_CASE("a full disk ends a run with exit code 4 and leaves no partial file") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    const tumble::test::SmallDisk disk(folder / "disk", 256);
    const fs::path out = folder / "disk/out";
    const Answer frames =
        tumble::test::run_tumble({"run", scene, "--duration", "100", "--size", "640x360", "-o", out.string()});
    CHECK(frames.code == 4);
    CHECK_MESSAGE(frames.err.find("No space left") != std::string::npos, frames.err);
    CHECK(check_frames(out / "frames") > 0);
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder / "disk"))
        CHECK(entry.path().extension() != ".partial");

    fs::remove_all(out);
    const Answer trajectory =
        tumble::test::run_tumble({"run", scene, "--no-frames", "--duration", "100", "-o", (folder / "out").string(),
                                  "--trajectory", (folder / "disk/trajectory.csv").string()});
    CHECK(trajectory.code == 4);
    CHECK(trajectory.err.find("trajectory.csv") != std::string::npos);
    CHECK(fs::is_empty(folder / "disk"));
}

TEST_CASE("a failed write to standard output ends with exit code 4") {
    Process process(tumble::test::tumble_command({"schema"}), ".", "", "/dev/full");
    CHECK(process.wait().code == 4);
}
