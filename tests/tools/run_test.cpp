// The files of a run.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "process.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::read_text;
using tumble::test::run_tumble;

namespace {

std::vector<std::string> lines_of(const fs::path& file) {
    std::vector<std::string> lines;
    std::istringstream text(read_text(file));
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
}

// "body_a,body_b" of a line of contacts.
std::string bodies_of(const std::string& line) {
    const std::size_t first = line.find(',') + 1, second = line.find(',', first) + 1;
    return line.substr(first, line.find(',', second) - first);
}

std::size_t count_files(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

std::string small_scene_file(const Folder& folder) { return folder.write("small.json", tumble::test::small_scene()); }

}  // namespace

TEST_CASE("five seconds at 60 frames per second are 301 frames") {
    const Folder folder;
    const fs::path out = folder / "out";
    const std::string pyramid = TUMBLE_SOURCE_DIR "/scenes/pyramid.json";
    const Answer answer =
        run_tumble({"run", pyramid, "--duration", "5", "--fps", "60", "--size", "64x36", "-o", out.string()});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(count_files(out / "frames") == 301);
    CHECK(fs::exists(out / "frames/frame_000000.png"));
    CHECK(fs::exists(out / "frames/frame_000300.png"));
    CHECK(answer.out.find("state hash") != std::string::npos);
}

TEST_CASE("the summary has every key that scripts rely on, and --json prints the same document") {
    const Folder folder;
    const fs::path out = folder / "out";
    const Answer answer =
        run_tumble({"run", small_scene_file(folder), "--json", "--duration", "1", "--no-frames", "-o", out.string()});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json summary = json::parse(answer.out);
    CHECK(summary == json::parse(read_text(out / "summary.json")));
    for (const char* key : {"version", "scene_hash", "seed", "dt", "steps", "wall_s", "bodies", "contacts",
                            "state_hash", "files", "complete"}) {
        CAPTURE(key);
        CHECK(summary.contains(key));
    }
    for (const char* key : {"simulate", "render", "encode", "total"}) CHECK(summary["wall_s"].contains(key));
    CHECK(summary["steps"] == 60);
    CHECK(summary["dt"].get<double>() == 1.0 / 60.0);
    CHECK(summary["bodies"] == 3);
    CHECK(summary["complete"] == true);
    CHECK(summary["state_hash"].get<std::string>().size() == 16);
    for (const char* key : {"bodies", "islands", "contacts", "contact_points", "joints", "colors", "pairs", "collided",
                            "gjk_iterations"}) {
        CAPTURE(key);
        CHECK(summary["counters"][key].is_number_integer());
    }
    for (const char* key :
         {"pairs", "collide", "prepare", "solve", "continuous", "proxies", "events", "sleep", "step"}) {
        CAPTURE(key);
        CHECK(summary["ms_per_step"][key].get<double>() >= 0.0);
    }
    CHECK(summary["counters"]["contacts"] == summary["contacts"]);
    CHECK(summary["memory_bytes"]["total"].get<double>() > 1000.0);
    CHECK_FALSE(fs::exists(out / "frames"));
}

TEST_CASE("the summary counts the bodies at the end, without despawned ones") {
    const Folder folder;
    const std::string scene = folder.write("despawn.json", R"({"format": 1, "name": "despawn",
        "bodies": [{"name": "ball", "shapes": [{"circle": {"radius": 1}}]}, {"position": [5, 0], "shapes": [{"circle": {"radius": 1}}]}],
        "timeline": [{"at": 0.5, "despawn": "ball"}]})");
    const auto bodies_after = [&](const std::string& duration) {
        const std::string out = (folder / duration).string();
        const Answer answer = run_tumble({"run", scene, "--json", "--no-frames", "--duration", duration, "-o", out});
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        return json::parse(answer.out)["bodies"].get<int>();
    };
    CHECK(bodies_after("0.4") == 2);
    CHECK(bodies_after("0.6") == 1);
}

TEST_CASE("events.csv lists contacts and sleep, and --contacts lists every point of every step") {
    const Folder folder;
    const fs::path out = folder / "out", file = folder / "contacts.csv";
    const Answer answer = run_tumble({"run", small_scene_file(folder), "--duration", "4", "--no-frames", "-o",
                                      out.string(), "--contacts", file.string(), "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const std::vector<std::string> events = lines_of(out / "events.csv");
    REQUIRE(!events.empty());
    CHECK(events[0] == "step,time,event,a,b,x,y,nx,ny,speed");
    const auto count = [&](const std::string& kind) {
        return std::ranges::count_if(events,
                                     [&](const std::string& line) { return line.find(kind) != std::string::npos; });
    };
    CHECK(count(",contact_begin,ground,ball,") >= 1);
    // A contact that exists at the end has one more begin event than end events.
    const std::vector<std::string> contacts = lines_of(file);
    REQUIRE(!contacts.empty());
    CHECK(contacts[0] == "step,body_a,body_b,feature,x,y,nx,ny,separation,normal_impulse,tangent_impulse");
    const json summary = json::parse(answer.out);
    const auto is_of_the_end = [](const std::string& line) { return line.starts_with("240,"); };
    std::set<std::string> touching;
    for (const std::string& line : contacts)
        if (is_of_the_end(line)) touching.insert(bodies_of(line));
    CHECK(count(",contact_begin,") - count(",contact_end,") == static_cast<int>(touching.size()));
    const auto at_end = std::ranges::count_if(contacts, is_of_the_end);
    CHECK(at_end == summary["counters"]["contact_points"].get<int>());
    for (const std::string& line : contacts) CHECK(std::ranges::count(line, ',') == 10);
    for (const std::string& line : events) CHECK(std::ranges::count(line, ',') == 9);
}

TEST_CASE("an overlay changes the frames, and an unknown part is refused with the list of parts") {
    const Folder folder;
    const std::string scene = small_scene_file(folder);
    const auto shoot = [&](const std::string& name, const std::string& overlay) {
        const std::string file = (folder / name).string();
        std::vector<std::string> arguments{"shot", scene, "--at", "1", "--size", "640x360", "-o", file};
        if (!overlay.empty()) arguments.insert(arguments.end(), {"--overlay", overlay});
        const Answer answer = run_tumble(arguments);
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        return read_text(file);
    };
    const std::string plain = shoot("plain.png", "");
    for (const char* part : {"contacts", "normals", "aabbs", "islands", "velocity", "joints", "forces"}) {
        CAPTURE(part);
        CHECK(shoot(std::string(part) + ".png", part) != plain);
    }
    CHECK(shoot("two.png", "contacts,normals") != shoot("one.png", "contacts"));
    const Answer refused = run_tumble({"run", scene, "--overlay", "contacts,torques"});
    CHECK(refused.code == 2);
    CHECK(refused.err.find("contacts,normals,aabbs,islands,velocity,joints,forces") != std::string::npos);
}

TEST_CASE("two runs give the same hash after each step") {
    const Folder folder;
    const std::string scene = small_scene_file(folder);
    for (const char* name : {"a", "b"})
        REQUIRE(run_tumble({"run", scene, "--no-frames", "--duration", "2", "-o", (folder / name).string(), "--hashes",
                            (folder / (std::string(name) + ".csv")).string()})
                    .code == 0);
    const std::vector<std::string> lines = lines_of(folder / "a.csv");
    CHECK(lines == lines_of(folder / "b.csv"));
    REQUIRE(lines.size() == 122);  // the header, the initial state, 120 steps
    CHECK(lines[0] == "step,hash");
    CHECK(lines[1].starts_with("0,"));
    CHECK(lines[121].starts_with("120,"));
    CHECK(lines[1].substr(2) != lines[2].substr(2));
    const json summary = json::parse(read_text(folder / "a" / "summary.json"));
    CHECK(lines.back() == "120," + summary["state_hash"].get<std::string>());
}

TEST_CASE("a trajectory has one line per body and step") {
    const Folder folder;
    const fs::path file = folder / "sub/trajectory.csv";
    REQUIRE(run_tumble({"run", small_scene_file(folder), "--no-frames", "--duration", "0.5", "-o",
                        (folder / "out").string(), "--trajectory", file.string()})
                .code == 0);
    const std::vector<std::string> lines = lines_of(file);
    REQUIRE(lines.size() == 1 + 31 * 3);
    CHECK(lines[0] == "step,time,body,x,y,angle,vx,vy,omega");
    CHECK(lines[1] == "0,0,ground,0,-0.5,0,0,0,0");
    CHECK(lines[2] == "0,0,ball,0,3,0,1,0,0");
    CHECK(lines[3].starts_with("0,0,body[2],0.2,5,0.523598"));
    CHECK(lines[4].starts_with("1,0.016666666666666666,ground,"));
}

TEST_CASE("a table whose name promises another format than CSV is refused") {
    const Folder folder;
    const std::string scene = small_scene_file(folder);
    for (const char* const name : {"run.h5", "run.npy", "run.json"}) {
        const Answer answer = run_tumble(
            {"run", scene, "--no-frames", "-o", (folder / "out").string(), "--trajectory", (folder / name).string()});
        CHECK(answer.code == 2);
        CHECK(answer.err.find("tables are CSV") != std::string::npos);
    }
    CHECK(!fs::exists(folder / "out"));
    const std::string temporary = (folder / "tmp.Xy12Zb").string();
    CHECK(run_tumble({"run", scene, "--no-frames", "-o", (folder / "out").string(), "--trajectory", temporary}).code ==
          0);
}

TEST_CASE("a run without -o writes to out/<scene name>") {
    const Folder folder;
    small_scene_file(folder);
    const Answer answer = tumble::test::run(
        tumble::test::tumble_command({"run", "small.json", "--duration", "0", "--size", "32x32"}), folder.path());
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(fs::exists(folder / "out/small/summary.json"));
    CHECK(count_files(folder / "out/small/frames") == 1);
}

TEST_CASE("nothing is overwritten silently") {
    const Folder folder;
    const std::string scene = small_scene_file(folder);
    const std::string out = (folder / "out").string();
    const std::vector<std::string> base = {"run", scene, "--size", "32x32", "-o", out, "--duration"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), base.begin(), base.end());
        return run_tumble(more);
    };
    REQUIRE(with({"0.1"}).code == 0);
    CHECK(count_files(folder / "out/frames") == 7);
    const std::string before = read_text(folder / "out/summary.json");
    const Answer refused = with({"0.05"});
    CHECK(refused.code == 4);
    CHECK(refused.err.find("--force") != std::string::npos);
    CHECK(read_text(folder / "out/summary.json") == before);
    folder.write("out/notes.txt", "mine");
    CHECK(with({"0.05", "--force"}).code == 0);
    CHECK(count_files(folder / "out/frames") == 4);  // no frame of the longer run is left
    CHECK(fs::exists(folder / "out/notes.txt"));
    const std::string precious = folder.write("h.csv", "mine");
    CHECK(run_tumble({"run", scene, "--no-frames", "-o", (folder / "b").string(), "--hashes", precious}).code == 4);
    CHECK(read_text(precious) == "mine");
}

TEST_CASE("more frames than steps repeat frames, with a warning") {
    const Folder folder;
    const Answer answer = run_tumble({"run", small_scene_file(folder), "--fps", "240", "--duration", "0.05", "--size",
                                      "64x36", "-o", (folder / "out").string()});
    CHECK(answer.code == 0);
    CHECK(answer.err.find("warning") != std::string::npos);
    CHECK(count_files(folder / "out/frames") == 13);
    // Frame 2 shows step round(2 x 60 / 240) = 1, as frame 3 does.
    CHECK(read_text(folder / "out/frames/frame_000002.png") == read_text(folder / "out/frames/frame_000003.png"));
}

TEST_CASE("a shot equals the frame of a run at that time") {
    const Folder folder;
    const std::string scene = small_scene_file(folder);
    REQUIRE(run_tumble({"run", scene, "--duration", "0.5", "--size", "160x90", "-o", (folder / "out").string()}).code ==
            0);
    const std::string file = (folder / "new/shot.png").string();
    const Answer answer = run_tumble({"shot", scene, "--at", "0.5", "--size", "160x90", "-o", file});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(read_text(file) == read_text(folder / "out/frames/frame_000030.png"));
    CHECK(run_tumble({"shot", scene, "-o", file}).code == 4);
    CHECK(run_tumble({"shot", scene, "-o", file, "--force"}).code == 0);
}

TEST_CASE("a following camera gives the same frame in a shot and in a run at any frame rate") {
    const Folder folder;
    // The ball turns. It is created between two frames of the slower run and destroyed between two others.
    const std::string scene = folder.write("late.json", R"({"format": 1, "name": "late", "world": {"duration": 0.5},
        "camera": {"center": [1, 2], "follow": "ball"},
        "bodies": [{"name": "floor", "type": "static", "shapes": [{"box": {"size": [9, 1]}}]}],
        "timeline": [{"at": 0.06, "spawn": {"name": "ball", "position": [0, 3], "velocity": [2, 0], "angular_velocity": 300,
                                            "shapes": [{"box": {"size": [1, 0.3]}}]}},
                     {"at": 0.36, "despawn": "ball"}]})");
    REQUIRE(run_tumble({"run", scene, "--size", "160x90", "-o", (folder / "60").string()}).code == 0);
    REQUIRE(run_tumble({"run", scene, "--size", "160x90", "--fps", "10", "-o", (folder / "10").string()}).code == 0);
    for (const std::size_t tenth : {std::size_t{0}, std::size_t{2}, std::size_t{3}, std::size_t{5}}) {
        const std::string shot = (folder / (std::to_string(tenth) + ".png")).string();
        REQUIRE(
            run_tumble({"shot", scene, "--at", "0." + std::to_string(tenth), "--size", "160x90", "-o", shot}).code ==
            0);
        const std::string frame = std::to_string(6 * tenth);
        CHECK(read_text(shot) ==
              read_text(folder / ("60/frames/frame_" + std::string(6 - frame.size(), '0') + frame + ".png")));
        CHECK(read_text(shot) == read_text(folder / ("10/frames/frame_00000" + std::to_string(tenth) + ".png")));
    }
}

TEST_CASE("--set and --seed change the scene") {
    const Folder folder;
    const Answer answer =
        run_tumble({"run", small_scene_file(folder), "--no-frames", "--json", "-o", (folder / "out").string(), "--set",
                    "/world/steps_per_second=30", "--set", "/world/duration=2", "--seed", "77"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json summary = json::parse(answer.out);
    CHECK(summary["steps"] == 60);
    CHECK(summary["seed"] == 77);
    CHECK(run_tumble({"run", (folder / "small.json").string(), "--no-frames", "-o", (folder / "b").string(), "--set",
                      "/world/substeps=0"})
              .code == 2);
}
