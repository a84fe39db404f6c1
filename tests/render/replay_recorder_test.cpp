// What the recorder of replays writes into the header of a page.
#include <doctest/doctest.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb_image.h>

#include "hand_made_scene.hpp"
#include "render/replay/body_tracks.hpp"
#include "render/replay/event_marks.hpp"
#include "tumble/recording.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;

namespace {

// The JSON header in a page.
nlohmann::json header_of(const std::string& page) {
    const std::string element = "<script id=\"states\" type=\"application/octet-stream\">";
    const std::size_t begin = page.find(element) + element.size();
    std::string packed;
    unsigned bits = 0, count = 0;
    for (const char letter : page.substr(begin, page.find('<', begin) - begin)) {
        const std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        if (letter == '=') break;
        bits = (bits << 6 | static_cast<unsigned>(digits.find(letter))) & 0xffff;
        if ((count += 6) >= 8) packed += static_cast<char>(bits >> (count -= 8));
    }
    int size = 0;
    const std::unique_ptr<char, void (*)(void*)> bytes(
        stbi_zlib_decode_malloc(packed.data(), static_cast<int>(packed.size()), &size), std::free);
    REQUIRE(bytes != nullptr);
    const std::string states(bytes.get(), static_cast<std::size_t>(size));
    std::size_t at = 0, length = 0;
    for (std::size_t weight = 1;; weight *= 128) {
        const auto byte = static_cast<unsigned char>(states.at(at++));
        length += (byte % 128) * weight;
        if (byte < 128) break;
    }
    return nlohmann::json::parse(states.substr(at, length));
}

}  // namespace

TEST_CASE("a replay states the theme of its settings or of its scene, and has the fills of that theme") {
    HandMadeScene made;
    made.add_dynamic("puck", {0.0, 0.0}, make_circle(0.5f));
    const auto header = [&](std::optional<Theme> theme) {
        ReplayRecorder recorder(made.scene, {.theme = theme});
        recorder.record(made.built, {});
        return header_of(recorder.page({}, true));
    };
    const auto fill = [](const nlohmann::json& of) { return of["bodies"][0]["shapes"][0][1]; };
    CHECK(header(std::nullopt)["theme"] == "");
    CHECK(header(Theme::light)["theme"] == "light");
    CHECK(header(Theme::print)["theme"] == "print");
    CHECK(fill(header(Theme::print)) == "#f0f0f0");
    CHECK(fill(header(Theme::dark)) == fill(header(Theme::light)));  // the page darkens it
    made.scene.camera.style.theme = Theme::color_blind;
    CHECK(header(std::nullopt)["theme"] == "color_blind");
    CHECK(header(std::nullopt)["island_colors"][1] == "#e69f00");
    CHECK(header(Theme::light)["theme"] == "light");
}

TEST_CASE("a replay has the notes of its scene, whose text is no markup in the page") {
    const std::string text = "</script><b onclick='x'>\"quoted\" \\ \xe2\x80\xa8 next\nline";
    HandMadeScene made;
    made.scene.camera.notes = {{.text = text, .position = DVec2{1.5, 2.0}, .from = 0.5, .until = 2.0},
                               {.text = "over it", .above = "puck"}};
    made.add_dynamic("puck", {0.0, 0.0}, make_circle(0.5f));
    ReplayRecorder recorder(made.scene, {});
    recorder.record(made.built, {});
    const std::string page = recorder.page({}, true);
    CHECK(page.find("onclick") == std::string::npos);
    const nlohmann::json notes = header_of(page)["notes"];
    CHECK(notes ==
          nlohmann::json::array({{{"text", text}, {"from", 0.5}, {"until", 2.0}, {"position", {1.5, 2.0}}},
                                 {{"text", "over it"}, {"from", 0.0}, {"until", nullptr}, {"above", "puck"}}}));
}

TEST_CASE("events are marked at the first state that shows their effect") {
    Scene scene;
    SceneEvent push;
    push.at = 0.5;
    push.body = "ball";
    push.impulse = DVec2{1.0, 0.0};
    SceneEvent rain;
    rain.every = 0.25;
    rain.from = 0.1;
    rain.until = 0.7;
    rain.spawn = SceneBody{};
    rain.spawn->name = "drop";
    scene.timeline = {push, rain};
    const std::vector<render::EventMark> marks = render::timeline_marks(scene);
    REQUIRE(marks.size() == 4);
    // 0.1, 0.35 and 0.6 s are the begins of steps 6, 21 and 36, whose states are numbered one more.
    CHECK(marks[0].step == 7);
    CHECK(marks[0].text == "new body 'drop'");
    CHECK(marks[1].step == 22);
    CHECK(marks[2].step == 31);
    CHECK(marks[2].text == "impulse on 'ball'");
    CHECK(marks[3].step == 37);
}

TEST_CASE("an event is marked at the step in which the run applies it") {
    Scene scene;
    SceneBody ball;
    ball.name = "ball";
    ball.shapes.push_back({CircleGeometry{0.5, {}}, "", ""});
    scene.bodies = {ball};
    scene.world.gravity = {0.0, 0.0};
    SceneEvent push;
    push.body = "ball";
    push.velocity = DVec2{1.0, 0.0};
    // Within rounding of the begin of step 6, the last of them later than that; and half a step later.
    for (const double begin : {6.0, 6.0 - 5e-7, 6.0 + 5e-7, 6.5}) {
        CAPTURE(begin);
        push.at = begin / 60.0;
        scene.timeline = {push};
        SceneRun run(scene);
        while (run.world().state(run.built().bodies[0].id).velocity.x == 0.0f) run.step();
        const std::vector<render::EventMark> marks = render::timeline_marks(scene);
        REQUIRE(marks.size() == 1);
        CHECK(marks[0].step == run.world().step_count());
    }
}

TEST_CASE("an event that repeats is marked as often as the run applies it") {
    Scene scene;
    SceneEvent rain;
    rain.spawn = SceneBody{};
    rain.spawn->name = "drop";
    rain.spawn->shapes.push_back({CircleGeometry{0.1, {}}, "", ""});
    rain.from = 0.1;
    // The tenth is due within rounding after `until`; then 1 + floor(0.9 / 0.025), two in three steps.
    for (const auto& times : {std::pair(0.1, 1.0 - 1e-9), std::pair(0.025, 1.0)}) {
        CAPTURE(times.first);
        rain.every = times.first;
        rain.until = times.second;
        scene.timeline = {rain};
        SceneRun run(scene);
        std::vector<std::uint64_t> steps;
        while (run.world().step_count() < 150) {
            const std::size_t before = run.built().bodies.size();
            run.step();
            if (run.built().bodies.size() > before) steps.push_back(run.world().step_count());
        }
        std::vector<std::uint64_t> marked;
        for (const render::EventMark& mark : render::timeline_marks(scene)) marked.push_back(mark.step);
        CHECK(marked == steps);
        CHECK(steps.size() == (times.first == 0.1 ? 10 : 37));
    }
}

TEST_CASE("a body that takes the place of a destroyed one has a number of its own") {
    HandMadeScene made;
    const BodyId first = made.add_dynamic("first", {0.0, 1.0}, make_circle(0.5f));
    render::BodyTracks tracks(made.scene, 1e-3, render::colors_of(Theme::light));
    tracks.record(made.built, 0);
    made.built.world.destroy_body(first);
    const BodyId second = made.built.world.create_body({});
    made.built.bodies.push_back({second, 0, "second"});
    REQUIRE(second.index == first.index);
    tracks.record(made.built, 1);
    CHECK(tracks.numbers() == render::BodyNumbers{{first, 0}, {second, 1}});

    ReplayRecorder recorder(made.scene, {});
    recorder.record(made.built, {});
    const ReplayClaim claim{{.claim = "of the first", .finding = ""}, {.bodies = {first, second}}};
    CHECK(header_of(recorder.page(std::vector{claim}, true))["claims"][0]["bodies"] == nlohmann::json{0, 1});
}

TEST_CASE("bodies that are not of the scene are left out, with their contacts and joints") {
    HandMadeScene made;
    const BodyId floor = made.add_static("floor", {0.0, -1.0}, make_box({10.0f, 2.0f}));
    const BodyId other = made.built.world.create_body({.pose = {{0.0, 0.49}, {}}});
    made.built.world.add_shape(other, {.shape = make_circle(0.5f)});
    const BodyId hung = made.built.world.create_body({.pose = {{8.0, 5.0}, {}}});
    const JointId joint = made.built.world.create_joint(DistanceJointDef{.body_a = floor, .body_b = hung});
    made.built.joints.push_back({joint, 0, "rope"});
    ReplayRecorder recorder(made.scene, {});
    for (int i = 0; i < 5; ++i) {
        recorder.record(made.built, {.center = {}, .follows = other});
        made.built.world.step();
    }
    REQUIRE(!made.built.world.contacts().empty());
    const nlohmann::json header = header_of(recorder.page({}, true));
    CHECK(header["joints"].empty());
    CHECK(header["bodies"].size() == 1);
    CHECK(header["views"] == nlohmann::json::parse("[[0, -1, 0.0, 0.0, 1.0]]"));
}

TEST_CASE("the views are those of the cameras of the frames") {
    HandMadeScene made;
    made.add_static("floor", {0.0, -1.0}, make_box({10.0f, 2.0f}));
    ReplayRecorder recorder(made.scene, {.aspect_ratio = 1.5});
    Camera camera{.center = {1.0, 2.0}, .height = 8.0};
    const auto record = [&] {
        camera = move_camera(camera, made.scene, made.built);
        recorder.record(made.built, camera);
        made.built.world.step();
    };
    record();
    record();
    made.scene.camera.follow = "ball";
    made.scene.camera.height = 4.0;
    made.scene.camera.center = DVec2{3.5, 9.0};
    const BodyId ball = made.built.world.create_body({.pose = {{3.0, 9.0}, {}}});
    made.built.bodies.push_back({ball, 0, "ball"});
    record();
    record();
    made.built.world.destroy_body(ball);
    record();
    record();
    const nlohmann::json header = header_of(recorder.page({}, true));
    CHECK(header["aspect_ratio"] == 1.5);
    REQUIRE(header["views"].size() == 3);
    CHECK(header["views"][0] == nlohmann::json::parse("[0, -1, 1.0, 2.0, 8.0]"));
    CHECK(header["views"][1] == nlohmann::json::parse("[2, 1, 0.5, 0.0, 4.0]"));
    // Where the camera was in step 3.
    CHECK(header["views"][2] == nlohmann::json{4, -1, camera.center.x, camera.center.y, 4.0});
}

TEST_CASE("marks of broken joints and of the timeline are in the order of time") {
    HandMadeScene made;
    SceneEvent push;
    push.gravity = DVec2{};
    push.at = 0.5;  // step 31
    made.scene.timeline = {push};
    const BodyId ceiling = made.add_static("ceiling", {0.0, 5.0}, make_box({1.0f, 1.0f}));
    const BodyId weight = made.add_dynamic("weight", {0.0, 3.0}, make_circle(0.5f));
    DistanceJointDef rope{.body_a = ceiling, .body_b = weight};
    rope.length = 2.0f;
    rope.break_force = 0.1f;
    made.built.joints.push_back({made.built.world.create_joint(rope), 0, "rope"});
    ReplayRecorder recorder(made.scene, {});
    for (int i = 0; i <= 40; ++i) {
        recorder.record(made.built, {});
        made.built.world.step();
    }
    const nlohmann::json events = header_of(recorder.page({}, true))["events"];
    REQUIRE(events.size() == 2);
    CHECK(events[0]["text"] == "joint 'rope' breaks");
    CHECK(events[1] == nlohmann::json{{"step", 31}, {"text", "gravity changes"}});
}

TEST_CASE("an event with a condition is marked in the first state with its effect") {
    const Scene scene = parse_scene(R"({"format": 1, "world": {"gravity": [0, 0]}, "bodies": [
        {"name": "puck", "velocity": [3, 0], "shapes": [{"circle": {"radius": 0.5}}]}], "timeline": [
        {"when": "puck.x > 0.99", "body": "puck", "velocity": [0, 3]},
        {"when": "puck.y > 0.99", "delay": 0.5, "stop": true},
        {"when": "puck.x > 9", "gravity": [0, 0]}]})",
                                    "scene.json");
    SceneRun run(scene);
    ReplayRecorder recorder(scene, {});
    recorder.record(run.built(), {});
    std::uint64_t turned = 0;
    while (!run.is_stopped()) {
        run.step();
        recorder.record(run.built(), {});
        if (turned == 0 && run.world().state(run.built().bodies[0].id).velocity.y > 0.0f)
            turned = run.world().step_count();
    }
    const nlohmann::json events = header_of(recorder.page({}, true))["events"];
    REQUIRE(events.size() == 2);
    CHECK(turned == 21);  // x is 1 m after 20 steps of 5 cm
    CHECK(events[0] == nlohmann::json{{"step", turned}, {"text", "velocity of 'puck'"}});
    CHECK(events[1] == nlohmann::json{{"step", run.world().step_count()}, {"text", "the run ends"}});
}

TEST_CASE("events after the last step are not marked") {
    HandMadeScene made;
    SceneEvent push;
    push.gravity = DVec2{};
    push.at = 0.1;
    made.scene.timeline = {push};
    ReplayRecorder recorder(made.scene, {});
    for (int i = 0; i <= 6; ++i) {
        recorder.record(made.built, {});
        CHECK(header_of(recorder.page({}, true))["events"].empty());
        made.built.world.step();
    }
    recorder.record(made.built, {});
    CHECK(header_of(recorder.page({}, true))["events"].size() == 1);
}

TEST_CASE("a replay ends at the limits of poses and of contact points") {
    const auto last_step = [](const ReplaySettings& settings) {
        HandMadeScene made;
        made.add_static("floor", {0.0, -1.0}, make_box({10.0f, 2.0f}));
        made.add_dynamic("ball", {0.0, 0.495}, make_circle(0.5f));
        ReplayRecorder recorder(made.scene, settings);
        for (int i = 0; i <= 50; ++i) {
            recorder.record(made.built, {});
            made.built.world.step();
        }
        const nlohmann::json header = header_of(recorder.page({}, true));
        CHECK(header["complete"] == recorder.is_whole());
        CHECK(header["bodies"][1]["count"].get<int>() == header["last_step"].get<int>() + 1);
        return header["last_step"].get<int>();
    };
    CHECK(last_step({}) == 50);
    CHECK(last_step({.most_poses = 42}) == 20);  // two bodies, and one state more than steps
    // One point in each step from step 1 on, and ten for the contact.
    CHECK(last_step({.most_contact_points = 30}) == 20);
    CHECK(last_step({.contacts = false, .most_contact_points = 30}) == 50);
}

TEST_CASE("a page is made after its scene is gone") {
    auto made = std::make_unique<HandMadeScene>();
    made->scene.name = "a name of more than a few characters";
    made->add_dynamic("ball", {0.0, 1.0}, make_circle(0.5f));
    ReplayRecorder recorder(made->scene, {});
    recorder.record(made->built, {});
    made.reset();
    CHECK(header_of(recorder.page({}, true))["name"] == "a name of more than a few characters");
}
