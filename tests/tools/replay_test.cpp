// Replay pages, in headless Chromium.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "process.hpp"
#include "replay_page.hpp"
#include "support/near.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::absolute;
using tumble::test::browse;
using tumble::test::Folder;
using tumble::test::make_page;
using tumble::test::near;
using tumble::test::read_text;

namespace {

void check_loaded(const json& loaded) {
    CAPTURE(loaded["page"].get<std::string>());
    CHECK_MESSAGE(loaded["failure"].is_null(), loaded["failure"].dump());
    CHECK_MESSAGE(loaded["console"].empty(), loaded["console"].dump());
    CHECK_MESSAGE(loaded["requests"].empty(), loaded["requests"].dump());
}

// The cells of the rows of a trajectory.
std::vector<std::vector<std::string>> states_in(const fs::path& file) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(read_text(file));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream cells(line);
        rows.emplace_back();
        for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    }
    rows.erase(rows.begin());
    return rows;
}

// `columns` times `rows` bodies that fall on a floor in a heap, for ten seconds.
std::string heap(int columns, int rows) {
    return R"({"format": 1, "name": "heap", "world": {"duration": 10}, "bodies": [
        {"name": "floor", "type": "static", "position": [0, -1], "shapes": [{"box": {"size": [400, 2]}}]},
        {"name": "box", "position": [0, 2], "angle": 20, "shapes": [{"box": {"size": [0.9, 0.6]}}],
         "repeat": {"grid": {"columns": )" +
           std::to_string(columns) + R"(, "rows": )" + std::to_string(rows / 2) +
           R"(, "spacing": [1.3, 1.7], "angle": 3}}},
        {"name": "ball", "position": [0.4, 30], "shapes": [{"circle": {"radius": 0.4}}],
         "repeat": {"grid": {"columns": )" +
           std::to_string(columns) + R"(, "rows": )" + std::to_string(rows / 2) +
           R"(, "spacing": [1.2, 1.2], "angle": 2}}}]})";
}

}  // namespace

TEST_CASE("the poses of a page are those of the trajectory, within half a millimetre") {
    const Folder folder;
    const std::string trajectory = (folder / "t.csv").string();
    const std::string page =
        make_page(folder, TUMBLE_SOURCE_DIR "/scenes/see_saw.json", {"--duration", "2", "--trajectory", trajectory});
    // [body][step]: [x, y, angle]
    const std::string ask_poses = R"({ const run = replay.player.run;
        const poseOf = (number, step) => { const { x, y, angle } = run.pose(number, step); return [x, y, angle]; };
        return run.bodies.map(({ from, count }, number) =>
            Array.from({ length: count }, (_, i) => poseOf(number, from + i))); })";
    const std::string ask_names = R"({ return replay.player.run.bodies.map((body) => body.name); })";
    const std::vector<json> answers = browse({"ask", page, ask_poses, ask_names});
    const json& poses = answers.at(0);
    const json& names = answers.at(1);
    const std::vector<std::vector<std::string>> rows = states_in(trajectory);
    REQUIRE(rows.size() > 1000);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::size_t step = std::stoul(rows[i][0]), body = i % names.size();
        CAPTURE(i);
        REQUIRE(names[body] == rows[i][2]);
        const json& pose = poses[body][step];
        const double half_quantum = 0.5e-3 + 1e-9;
        CHECK(near(pose[0].get<double>(), std::stod(rows[i][3]), absolute(half_quantum)));
        CHECK(near(pose[1].get<double>(), std::stod(rows[i][4]), absolute(half_quantum)));
        const double apart = std::remainder(pose[2].get<double>() - std::stod(rows[i][5]), 2.0 * 3.14159265358979);
        CHECK(near(apart, 0.0, absolute(3.14159265358979 / 4096 + 1e-6)));
    }
}

TEST_CASE("names of a scene are text in its page") {
    const Folder folder;
    const std::string name = "</script><script>document.title='markup'</script><!--";
    json scene = json::parse(tumble::test::small_scene());
    scene["name"] = name;
    scene["bodies"][1]["name"] = "<img src=x onerror=alert(1)> \"'&amp;";
    scene["bodies"][2]["name"] = "line\xe2\x80\xa8separator";
    scene["expect"] = json::array({{{"body", scene["bodies"][1]["name"]}, {"height", {-100, 100}}}});
    scene["timeline"] = json::array({{{"at", 0.1}, {"body", scene["bodies"][1]["name"]}, {"impulse", {0, 1}}}});
    const std::string page = make_page(folder, folder.write("hostile.json", scene.dump()));
    CHECK(read_text(page).find("onerror") == std::string::npos);
    check_loaded(browse({"load", page}).at(0));
    const std::vector<json> found = browse(
        {"ask", page, "{ return document.title; }", "{ return document.getElementById('name').textContent; }",
         "{ replay.player.choose(1); replay.player.draw(); return document.getElementById('body-name').textContent; }",
         "{ return [...document.querySelectorAll('.row.body span:first-child')].map((cell) => cell.textContent); }",
         "{ return document.querySelectorAll('script, img').length; }",
         "{ return document.getElementById('events').textContent; }"});
    CHECK(found[0] == name + " \xe2\x80\x93 replay");
    CHECK(found[1] == name);
    CHECK(found[2] == scene["bodies"][1]["name"]);
    CHECK(found[3] == json::array({"ground", scene["bodies"][1]["name"], scene["bodies"][2]["name"]}));
    CHECK(found[4] == 3);
    CHECK(found[5].get<std::string>().find("onerror") != std::string::npos);
}

TEST_CASE("a page draws the notes of its scene as text, while and where frames have them") {
    const Folder folder;
    const std::string text = "</script><img src=x>\"'&amp;\xe2\x80\xa8x\nsecond line";
    json scene = json::parse(tumble::test::small_scene());
    scene["camera"]["notes"] = json::array(
        {{{"text", text}, {"position", {1, 2}}, {"from", 0.1}, {"until", 0.2}}, {{"text", "top"}, {"above", "ball"}}});
    const std::string page = make_page(folder, folder.write("notes.json", scene.dump()));
    const std::string drawn = R"({ const p = replay.player, context = p.painter.context, texts = [];
        context.fillText = (text) => texts.push(text);
        for (const step of [0, 6, 11, 12]) { p.seek(step); p.draw(); texts.push(step); }
        p.on.notes = false;
        p.draw();
        delete context.fillText;
        return texts; })";
    const std::vector<json> found =
        browse({"ask", page, drawn, "{ return document.querySelectorAll('script, img').length; }",
                R"({ const run = replay.player.run, pose = run.pose(1, 7), [x, y] = run.notePoint(run.notes[1], 7);
              return [x - pose.x, y - pose.y]; })",
                "{ return document.getElementById('overlay-notes').disabled; }"});
    const std::string first = text.substr(0, text.find('\n'));
    CHECK(found[0] ==
          json::array({"top", 0, first, "second line", "top", 6, first, "second line", "top", 11, "top", 12}));
    CHECK(found[1] == 3);
    CHECK(near(found[2][0].get<double>(), 0.0, absolute(1e-9)));
    CHECK(near(found[2][1].get<double>(), 0.5, absolute(1e-9)));  // the radius of the ball
    CHECK(found[3] == false);
    const std::string without = make_page(folder, folder.write("none.json", tumble::test::small_scene()));
    CHECK(browse({"ask", without, "{ return document.getElementById('overlay-notes').disabled; }"})[0] == true);
}

TEST_CASE("a page seeks, plays, finds bodies, and marks claims and events") {
    const Folder folder;
    json scene = json::parse(tumble::test::small_scene());
    scene["world"]["duration"] = 1;
    scene["expect"] = json::parse(R"([{"body": "ball", "height": [50, 60]}, {"body": "ball", "touches": "ground"}])");
    scene["timeline"] = json::parse(R"([{"at": 0.9, "body": "ball", "impulse": [0, 9]}])");
    const std::string page = make_page(folder, folder.write("small.json", scene.dump()));
    const std::vector<json> found = browse(
        {"ask", page,
         R"({ const p = replay.player; p.seek(17); p.draw(); return document.getElementById("clock").textContent; })",
         R"({ const p = replay.player, y = (step) => p.run.pose(1, step).y; return [y(0), y(30)]; })",
         R"({ const p = replay.player;
              p.play();
              await new Promise((done) => setTimeout(done, 600));
              p.pause();
              return p.step; })",
         R"({ const search = document.getElementById("search");
              search.value = "BAL";
              search.dispatchEvent(new Event("input"));
              return [...document.querySelectorAll(".row.body")].map((row) => row.firstChild.textContent); })",
         R"({ return replay.player.run.claims.map((claim) => claim.passed); })",
         R"({ document.querySelector("#claims .bad").click();
              const claim = replay.player.run.claims[0];
              return [replay.player.step, document.getElementById("message").className, claim.regions.length]; })",
         R"({ return replay.player.run.events; })",
         R"({ const run = replay.player.run;
              let most = 0;
              const measure = (a, b, x, y) => { if (a === 0 || b === 0) most = Math.max(most, Math.abs(y)); };
              for (let step = 0; step <= 60; step++) run.eachContact(step, measure);
              return [run.contacts.tracks, most]; })",
         R"({ const p = replay.player, pose = p.run.pose(1, 60);
              p.camera.fit();
              p.seek(60);
              return bodyAt(p.painter, p.camera.world(...p.camera.pixels(pose.x, pose.y)), 60, 0); })",
         R"({ const p = replay.player, before = p.on.contacts;
              const press = (key, shiftKey = false) =>
                document.body.dispatchEvent(new KeyboardEvent("keydown", { key, shiftKey, bubbles: true }));
              p.seek(10);
              press("ArrowRight");
              press("ArrowRight", true);
              press("c");
              return [p.step, before, p.on.contacts]; })"});
    CHECK(found[0] == "0.28 s step 17 of 60");
    CHECK(found[1][0] == 3.0);
    CHECK(found[1][1].get<double>() < 2.0);  // 3 - 10 t^2 / 2 at 0.5 s
    CHECK(found[2].get<double>() > 17.0);
    CHECK(found[3] == json::array({"ball"}));
    CHECK(found[4] == json::array({false, true}));
    CHECK(found[5] == json::array({60, "bad", 1}));
    CHECK(found[6] == json::parse(R"([{"step": 55, "text": "impulse on 'ball'"}])"));
    // Points on the ground, at y = 0. The ball lands at 7.1 m/s at most: it overlaps by up to 7.1 / 60 - 0.02 m, of
    // which the point is at one half, and a point is within three quarters of 1 cm.
    CHECK(found[7][0].get<int>() > 0);
    CHECK(near(found[7][1].get<double>(), 0.0, absolute(0.049 + 0.0075)));
    CHECK(found[8] == 1);
    CHECK(found[9] == json::array({21, false, true}));  // a step, ten steps, contacts
}

TEST_CASE("1000 bodies in 600 steps fit into 700 kB, 1.2 MB with contacts, and are usable soon") {
    if (tumble::test::case_stride() > 1) return;  // sizes are the same in every build, and sanitizers take minutes
    const Folder folder;
    const std::string scene = folder.write("heap.json", heap(50, 20));
    const std::string with = make_page(folder, scene);
    const std::uintmax_t size_with = fs::file_size(with);
    const std::string without = make_page(folder, scene, {"--no-replay-contacts"});
    MESSAGE("with contacts " << size_with << " bytes, without " << fs::file_size(without));
    CHECK(size_with <= 1'200'000);
    CHECK(fs::file_size(without) <= 700'000);
    const json loaded = browse({"load", without}).at(0);
    check_loaded(loaded);
    MESSAGE("usable after " << loaded["usable_ms"].get<double>() << " ms");
    CHECK(loaded["usable_ms"].get<double>() < 5000.0);  // on any machine, however busy; 0.5 s is what a free one takes
}

TEST_CASE("the pages of all shipped scenes load without an error") {
    const Folder folder;
    std::vector<std::string> arguments{"load"};
    std::size_t index = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(TUMBLE_SOURCE_DIR "/scenes")) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".json" || name.ends_with(".schema.json")) continue;
        if (index++ % tumble::test::case_stride() != 0) continue;
        // A given camera saves the run that fits one.
        arguments.push_back(make_page(folder, entry.path().string(),
                                      {"--duration", "0.1", "--set", R"(/camera={"center": [0, 5], "height": 20})"}));
    }
    const std::vector<json> loaded = browse(arguments);
    REQUIRE(loaded.size() + 1 == arguments.size());
    for (const json& page : loaded) check_loaded(page);
}

TEST_CASE("Ctrl-C leaves a page of the steps done") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    const std::string page = (folder / "page.html").string();
    tumble::test::Process process(tumble::test::tumble_command(
        {"run", scene, "-o", (folder / "out").string(), "--size", "64x36", "--duration", "100000", "--replay", page}));
    const fs::path frame = folder / "out/frames/frame_000003.png";
    for (int tries = 0; tries < 12000 && !fs::exists(frame) && process.is_running(); ++tries)  // a minute at most
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    process.send_signal(SIGINT);
    CHECK(process.wait().code == 130);
    const json steps = json::parse(read_text(folder / "out/summary.json"))["steps"];
    const std::string ended = R"({ const run = replay.player.run; return [run.last_step, run.complete]; })";
    CHECK(browse({"ask", page, ended}).at(0) == json::array({steps, false}));
}
