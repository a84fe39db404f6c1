// `tumble compare`: its numbers are those of diff, its page and frames, and its errors.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "process.hpp"
#include "replay_page.hpp"
#include "support/near.hpp"
#include "tumble/render.hpp"
#include "video_probe.hpp"

using nlohmann::json;
using tumble::test::absolute;
using tumble::test::Answer;
using tumble::test::browse;
using tumble::test::Folder;
using tumble::test::near;
using tumble::test::number_in;
using tumble::test::probe;
using tumble::test::read_text;
using tumble::test::relative;
using tumble::test::run_tumble;

namespace {

// A ball in free fall, 1 kg, whose name and scene are markup.
constexpr const char* kFall = R"({
  "format": 1, "name": "</script><img src=x>",
  "world": {"duration": 1, "steps_per_second": 100},
  "bodies": [{"name": "</script>\"'ball", "position": [0, 10], "velocity": [1, 0],
              "shapes": [{"circle": {"radius": 0.5}}]}]
})";

std::vector<std::vector<double>> numbers_of(const std::string& csv) {
    std::vector<std::vector<double>> rows;
    std::istringstream lines(csv);
    std::string line;
    for (std::getline(lines, line); std::getline(lines, line);) {
        std::istringstream fields(line);
        rows.emplace_back();
        for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(std::stod(field));
    }
    return rows;
}

}  // namespace

TEST_CASE("the largest numbers of compare are those of diff, of which each step is one") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", tumble::test::small_scene());
    const std::string csv = (folder / "c.csv").string(), change = "/world/gravity=[0.5,-9]";
    const Answer answer = run_tumble({"compare", scene, scene, "--set", change, "--csv", csv, "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json diff = json::parse(run_tumble({"diff", scene, scene, "--set", change, "--json"}).out);
    CHECK(json::parse(answer.out) == diff);
    const auto rows = numbers_of(read_text(csv));
    REQUIRE(rows.size() > 10);
    const std::vector<std::string> kinds{"position", "angle", "velocity", "angular velocity"};
    for (const json& largest : diff["largest"]) {
        const auto kind = std::ranges::find(kinds, largest["of"].get<std::string>()) - kinds.begin();
        const auto column = static_cast<std::size_t>(2 + kind);
        CAPTURE(column);
        const auto row = std::ranges::max_element(rows, {}, [column](const auto& r) { return r[column]; });
        CHECK((*row)[column] == largest["apart"].get<double>());
        CHECK((*row)[0] == largest["step"].get<double>());
    }
    CHECK(diff["largest"].size() >= 2);
}

TEST_CASE("compare of engines has the energy of a falling ball in both, and the first step that parts them") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kFall), csv = (folder / "c.csv").string();
    const Answer answer =
        run_tumble({"compare", scene, "--engine", "box2d", "--csv", csv, "--set",
                    "/materials={\"m\":{\"density\":1.2732395447351628}}", "--set", "/bodies/0/shapes/0/material=m"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(answer.out.find(" beside Box2D 2.4") != std::string::npos);
    const auto rows = numbers_of(read_text(csv));
    REQUIRE(rows.size() == 101);
    // 1 kg (density 4 / pi, radius 0.5) at a height of 10 m, 1 m/s, under the scenes' gravity of 10 m/s^2: 100 + 0.5 J.
    for (const std::size_t column : {6u, 7u}) CHECK(near(rows[0][column], 100.5, relative(1e-6)));
    // Box2D integrates with the velocity at the end of a step: after n steps of h it is g h^2 n / 2 below the parabola,
    // on which tumble stays.
    for (const std::size_t n : {1u, 50u, 100u})
        CHECK(near(rows[n][2], 0.5 * 10.0 * 1e-4 * static_cast<double>(n), absolute(2e-5)));
    // 1.02 cm apart after 20.4 steps.
    const Answer parted = run_tumble({"compare", scene, "--engine", "box2d", "--csv", "-", "--tolerance", "0.0102"});
    CHECK(parted.err.find("the first difference is at step 21 ") != std::string::npos);
}

TEST_CASE("the page of compare has pictures and plots, and text of the scene is no markup") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kFall), page = (folder / "c.html").string();
    const Answer answer = run_tumble({"compare", scene, "--engine", "box2d", "-o", page, "--size", "160x90"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const std::string text = read_text(page);
    CHECK(text.find("</script>") == std::string::npos);
    CHECK(text.find("<img src=x>") == std::string::npos);
    CHECK(text.find("http:") == std::string::npos);
    CHECK(text.find("https:") == std::string::npos);
    CHECK(text.find("&lt;/script&gt;") != std::string::npos);
    CHECK(text.find("src=\"data:image/png;base64,iVBORw0KGgo") != std::string::npos);
    CHECK(text.find("Kinetic and potential energy") != std::string::npos);
    CHECK(text.find("1 cm apart") != std::string::npos);
    CHECK(run_tumble({"compare", scene, "--engine", "box2d", "-o", page}).code == 4);
}

TEST_CASE("the frames of compare are one for each time, side by side or over each other, above the plot") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kFall);
    for (const bool is_overlaid : {false, true}) {
        const std::filesystem::path frames = folder / (is_overlaid ? "over" : "beside");
        std::vector<std::string> command{"compare",       scene,   "--engine", "box2d",  "--frames",
                                         frames.string(), "--fps", "10",       "--size", "400x100"};
        if (is_overlaid) command.emplace_back("--overlaid");
        const Answer answer = run_tumble(command);
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        CHECK(std::distance(std::filesystem::directory_iterator(frames), {}) == 11);
        const std::string png = read_text(frames / "frame_000010.png");
        const auto side = [&](std::size_t at) {
            return static_cast<unsigned char>(png[at + 2]) * 256 + static_cast<unsigned char>(png[at + 3]);
        };
        CHECK(side(16) == (is_overlaid ? 400 : 804));
        CHECK(side(20) == (is_overlaid ? 560 : 330));  // plots of 230 pixels, below each other or beside
    }
}

TEST_CASE("the page of compare plays both runs, with their own poses and the numbers of the table") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kFall), page = (folder / "c.html").string();
    REQUIRE(run_tumble({"compare", scene, "--engine", "box2d", "-o", page, "--size", "160x90"}).code == 0);
    const json loaded = browse({"load", page}).at(0);
    CHECK_MESSAGE(loaded["failure"].is_null(), loaded["failure"].dump());
    CHECK_MESSAGE(loaded["console"].empty(), loaded["console"].dump());
    CHECK_MESSAGE(loaded["requests"].empty(), loaded["requests"].dump());
    const std::vector<json> found = browse(
        {"ask", page,
         R"({ const p = replay.player; p.seek(100); p.draw();
              return [p.step, ...p.runs.map((run) => run.pose(0, 100).y), p.numbers.distances[100], p.numbers.first]; })",
         R"({ return ["name", "name-a", "distance-text", "clock"].map((id) => document.getElementById(id).textContent); })",
         R"({ const shown = (id) => { const box = document.getElementById(id).getBoundingClientRect(); return [box.left, box.width]; };
              const apart = [shown("world-a"), shown("world-b")];
              document.getElementById("overlaid").click();
              return [apart, [shown("world-a"), shown("world-b")]]; })",
         R"({ const p = replay.player;
              p.seek(0);
              document.body.dispatchEvent(new KeyboardEvent("keydown", { key: "d", bubbles: true }));
              const first = p.step;
              p.play();
              await new Promise((done) => setTimeout(done, 600));
              p.pause();
              return [first, p.step]; })",
         R"({ const p = replay.player; p.camera.fit(); p.seek(50); p.draw();
              const pixel = (i) => {
                const pose = p.runs[i].pose(0, 50), [x, y] = p.camera.pixels(pose.x + 0.2, pose.y + 0.2), canvas = p.canvas(i);
                return [...canvas.getContext("2d").getImageData(x * p.painters[i].ratio, y * p.painters[i].ratio, 1, 1).data];
              };
              const ground = [...p.canvas(0).getContext("2d").getImageData(1, 1, 1, 1).data];
              return [pixel(0), pixel(1), ground]; })",
         R"({ return document.querySelectorAll("img, script").length; })"});
    // Free fall for 1 s from 10 m; Box2D is g h t / 2 = 0.05 m below. Poses are within half a millimetre, as float.
    CHECK(found[0][0] == 100);
    CHECK(near(found[0][1].get<double>(), 5.0, absolute(6e-4)));
    CHECK(near(found[0][2].get<double>(), 4.95, absolute(6e-4)));
    CHECK(near(found[0][3].get<double>(), 0.05, absolute(2e-5)));
    CHECK(found[0][4] == 20);  // 1 cm, the tolerance of engines, after 20 steps, within the rounding of Box2D's float
    CHECK(found[1][0] == "</script><img src=x>");
    CHECK(found[1][1].get<std::string>().starts_with("tumble "));
    CHECK(found[1][2].get<std::string>().starts_with("Largest difference in x or y: 0.05"));
    CHECK(found[1][3] == "1.00 s step 100 of 100");
    CHECK(found[2][0][0][0] != found[2][0][1][0]);  // beside each other
    CHECK(found[2][1][0] == found[2][1][1]);        // over each other
    CHECK(found[3][0] == found[0][4]);
    CHECK(found[3][1].get<double>() > found[3][0].get<double>());
    CHECK(found[4][0] == found[4][1]);  // the colour of the ball where each run has it
    CHECK(found[4][0] != found[4][2]);
    CHECK(found[5] == 4);
}

TEST_CASE("the video of compare has one frame for each time, and Ctrl-C completes it") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kFall);
    const std::filesystem::path video = folder / "c.mp4";
    const std::vector<std::string> command{"compare",      scene,   "--engine", "box2d",  "--video",
                                           video.string(), "--fps", "10",       "--size", "400x100"};
    const Answer answer = run_tumble(command);
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json stream = probe(video)["streams"].at(0);
    CHECK(stream["nb_read_frames"] == "11");
    CHECK(stream["r_frame_rate"] == "10/1");
    CHECK(stream["width"] == 804);
    CHECK(stream["height"] == 330);
    CHECK(stream["color_space"] == "bt709");
    CHECK(run_tumble(command).code == 4);

    const std::filesystem::path long_video = folder / "long.mp4";
    tumble::test::Process process(
        tumble::test::tumble_command({"compare", scene, scene, "--set", "/world/duration=300", "--duration", "300",
                                      "--video", long_video.string(), "--fps", "100", "--size", "400x100"}));
    const int encoder = tumble::test::wait_for_encoder(long_video, process);
    REQUIRE(encoder > 0);
    REQUIRE(tumble::test::wait_for_frames(encoder, 4'000'000));  // five frames
    process.send_signal(SIGINT);
    CHECK(process.wait().code == 130);
    const double frames = number_in(probe(long_video)["streams"].at(0)["nb_read_frames"]);
    CHECK(frames > 0.0);
    CHECK(frames < 30001.0);
}

TEST_CASE("trajectories are compared without pictures, and wrong arguments of compare end with exit code 2") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kFall), table = (folder / "t.csv").string();
    REQUIRE(run_tumble({"run", scene, "--no-frames", "-o", (folder / "r").string(), "--trajectory", table}).code == 0);
    const std::string csv = (folder / "c.csv").string();
    REQUIRE(run_tumble({"compare", table, scene, "--csv", csv, "-o", (folder / "c.html").string()}).code == 0);
    const auto rows = numbers_of(read_text(csv));
    REQUIRE(rows.size() == 101);
    for (const auto& row : rows) CHECK(row[2] == 0.0);
    CHECK(read_text(folder / "c.html").find("<img") == std::string::npos);
    for (const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{
             {"compare", scene, scene},
             {"compare", scene, "--csv", csv},
             {"compare", scene, scene, "--engine", "box2d", "--csv", csv},
             {"compare", table, "--engine", "box2d", "--csv", csv},
             {"compare", scene, "--engine", "bullet", "--csv", csv},
             {"compare", scene, scene, "--video", (folder / "c.avi").string()},
             {"compare", scene, scene, "--video", (folder / "c.mp4").string(), "--size", "400x101"},
             {"compare", table, scene, "--video", (folder / "c.mp4").string()},
             {"compare", scene, table, "--frames", (folder / "frames").string(), "--csv", (folder / "d.csv").string()},
             {"compare", scene, scene, "-o", (folder / "x.mp4").string(), "--video", (folder / "x.mp4").string()},
             {"compare", scene, table, "--seed", "3", "--csv", csv}}) {
        const Answer answer = run_tumble(wrong);
        CHECK_MESSAGE(answer.code == 2, answer.err);
    }
    CHECK(!std::filesystem::exists(folder / "frames"));
}

TEST_CASE("compare warns of options of frames and pictures that it does not draw") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", kFall);
    const Answer answer = run_tumble({"compare", scene, scene, "--csv", (folder / "c.csv").string(), "--fps", "10",
                                      "--overlaid", "--renderer", "osmesa", "--theme", "dark"});
    CHECK(answer.code == 0);
    CHECK(answer.err.find("--fps has no effect without frames") != std::string::npos);
    for (const std::string option : {"--overlaid", "--renderer", "--theme"})
        CHECK(answer.err.find(option + " has no effect without pictures") != std::string::npos);
}

TEST_CASE("compare finds a missing ffmpeg before it simulates") {
    const Folder folder;
    // The simulation alone would take minutes.
    const std::string scene = folder.write("scene.json", R"({"format": 1, "world": {"duration": 100000}, "bodies": [
        {"name": "ball", "velocity": [1, 0], "shapes": [{"circle": {"radius": 0.5}}]}]})");
    std::vector<std::string> command = tumble::test::tumble_command(
        {"compare", scene, scene, "--csv", (folder / "c.csv").string(), "--video", (folder / "c.mp4").string()});
    command.insert(command.begin(), {"/usr/bin/env", "PATH=" + folder.path().string()});
    const Answer answer = tumble::test::run(command);
    CHECK(answer.code == 5);
    CHECK(answer.err.find("the program ffmpeg") != std::string::npos);
    CHECK(!std::filesystem::exists(folder / "c.csv"));
}

TEST_CASE("the frames of both runs have the theme of A") {
    const Folder folder;
    json bright = json::parse(kFall);
    bright["camera"]["style"]["theme"] = "high_contrast";
    const std::string a = folder.write("a.json", bright.dump()), b = folder.write("b.json", kFall);
    const std::string frames = (folder / "frames").string();
    REQUIRE(
        run_tumble({"compare", a, b, "--frames", frames, "--fps", "1", "--size", "400x100", "--hide", "grid"}).code ==
        0);
    const tumble::Image image = tumble::read_png(folder / "frames/frame_000000.png");
    for (const int column : {1, 403 + 1 + 1}) {  // 400 pixels, a gap of 4, and the other
        const std::size_t at = 4 * (static_cast<std::size_t>(image.width) * 1 + static_cast<std::size_t>(column));
        CHECK(int{image.rgba.at(at)} == 0);
    }
    for (const std::size_t at : {std::size_t{402}, static_cast<std::size_t>(image.width) * 105 + 1})
        CHECK(int{image.rgba.at(4 * at)} == 0x14);  // the gap of a dark theme, and the dark plots
}
