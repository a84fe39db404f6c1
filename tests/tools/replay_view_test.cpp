// What a replay page shows, and how it answers a user, in headless Chromium.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "process.hpp"
#include "replay_page.hpp"
#include "support/near.hpp"

using nlohmann::json;
using tumble::test::absolute;
using tumble::test::browse;
using tumble::test::Folder;
using tumble::test::make_page;
using tumble::test::near;

TEST_CASE("the view of a page is that of the frames, in any canvas") {
    const Folder folder;
    json scene = json::parse(tumble::test::small_scene());
    scene["world"]["duration"] = 1;
    scene["camera"] = json::parse(R"({"center": [2, 1], "height": 6})");
    // The frames are 24 m wide. What the page shows: the world's coordinates in the middle of the canvas, and whether
    // the upper and lower or the left and right edges of the frame are those of the canvas, as shares of its sides.
    const std::string ask_view = R"({ const p = replay.player, c = p.camera, shown = [];
        for (const step of [0, 30, 60]) {
          p.seek(step);
          p.draw();
          shown.push([...c.world(c.width / 2, c.height / 2), 6 * c.scale / c.height, 24 * c.scale / c.width]);
        }
        return shown; })";
    const std::string fixed = make_page(folder, folder.write("fixed.json", scene.dump()), {"--size", "640x160"});
    const json fixed_views = browse({"ask", fixed, ask_view}).at(0);
    for (const json& view : fixed_views) {
        CHECK(near(view[0].get<double>(), 2.0, absolute(1e-9)));
        CHECK(near(view[1].get<double>(), 1.0, absolute(1e-9)));
        CHECK(near(std::max(view[2].get<double>(), view[3].get<double>()), 1.0, absolute(1e-9)));
    }
    // A camera that follows the ball keeps the offset that its center has from the first position.
    scene["camera"]["follow"] = "ball";
    const std::string moving = make_page(folder, folder.write("moving.json", scene.dump()), {"--size", "640x160"});
    const std::string ask_ball = R"({ const run = replay.player.run,
          ball = run.bodies.findIndex((body) => body.name === "ball");
        return [0, 30, 60].map((step) => [run.pose(ball, step).x, run.pose(ball, step).y]); })";
    const std::vector<json> found = browse({"ask", moving, ask_view, ask_ball});
    const json &views = found.at(0), &balls = found.at(1);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double offset = (axis == 0 ? 2.0 : 1.0) - balls[0][axis].get<double>();
            CHECK(near(views[i][axis].get<double>(), balls[i][axis].get<double>() + offset, absolute(1e-9)));
        }
    CHECK(balls[2][1] != balls[0][1]);
}

TEST_CASE("a user who moves the view leaves that of the frames until Fit") {
    const Folder folder;
    const std::string page = make_page(folder, folder.write("small.json", tumble::test::small_scene()));
    const json found = browse({"ask", page, R"({ const p = replay.player, c = p.camera, seen = [c.asFrames];
        p.draw();
        const first = [c.x, c.y, c.scale];
        c.zoom(2, p.step, 0, 0);
        p.draw();
        seen.push(c.asFrames, c.scale / first[2]);
        document.getElementById("fit").click();
        p.draw();
        seen.push([c.x, c.y, c.scale].join() === first.join());
        p.choose(1);
        p.toggleFollow();
        p.seek(20);
        p.draw();
        const pose = p.run.pose(1, 20);
        seen.push(c.asFrames, c.x === pose.x && c.y === pose.y);
        return seen; })"})
                           .at(0);
    CHECK(found == json::parse("[true, false, 2, true, false, true]"));
}

TEST_CASE("Space acts once: on a button that has the focus, else on the player") {
    const Folder folder;
    const std::string page = make_page(folder, folder.write("small.json", tumble::test::small_scene()));
    // A browser presses a focused button only for a key that no listener has prevented.
    const json found = browse({"ask", page, R"({ const seen = [];
        for (const id of ["play", "fit", "overlay-joints", "scrubber", "world"]) {
          const event = new KeyboardEvent("keydown", { key: " ", bubbles: true, cancelable: true });
          replay.player.pause();
          document.getElementById(id).dispatchEvent(event);
          seen.push([replay.player.playing, event.defaultPrevented]);
        }
        return seen; })"})
                           .at(0);
    CHECK(found == json::parse("[[false, false], [false, false], [false, false], [true, true], [true, true]]"));
}

TEST_CASE("bodies touch where a contact has an impulse") {
    const Folder folder;
    json scene = json::parse(tumble::test::small_scene());
    scene["world"]["impacts"] = "at_step_end";  // so that a contact is near for a step before it pushes
    scene["world"]["duration"] = 2;
    const std::string page = make_page(folder, folder.write("small.json", scene.dump()));
    const json found = browse({"ask", page, R"({ const p = replay.player, run = p.run;
        let pressed = 0, near = 0;
        for (let step = 0; step <= run.last_step; step++) {
          const of = [new Set(), new Set()];
          run.eachContact(step, (a, b, x, y, nx, ny, impulse) => {
            if (a === 1 || b === 1) of[impulse > 0 ? 1 : 0].add(run.bodies[a === 1 ? b : a].name);
          });
          if (of[0].size > 0 && of[1].size === 0) near++;
          if (of[1].size > 0) pressed++;
          const text = of[1].size > 0 ? [...of[1]].join(", ") : "nothing";
          if (p.panel.touched(1, step) !== text) return [step, text, p.panel.touched(1, step)];
        }
        return [near > 0, pressed > 0]; })"})
                           .at(0);
    CHECK(found == json::parse("[true, true]"));
}

TEST_CASE("the contacts of a step are those of all tracks with a point in it") {
    const Folder folder;
    const std::string page = make_page(folder, TUMBLE_SOURCE_DIR "/scenes/see_saw.json", {"--duration", "4"});
    const json found = browse({"ask", page, R"({ const run = replay.player.run, { tracks, from, count } = run.contacts;
        let all = 0, wrong = 0;
        for (let step = 0; step <= run.last_step; step++) {
          let expected = 0, visited = 0;
          for (let i = 0; i < tracks; i++) if (step >= from[i] && step < from[i] + count[i]) expected++;
          run.eachContact(step, () => visited++);
          all += visited;
          if (visited !== expected) wrong++;
        }
        return [all === run.contacts.points[0].length, all > 240, wrong]; })"})
                           .at(0);
    CHECK(found == json::parse("[true, true, 0]"));
}

TEST_CASE("dashes are drawn in view only, however far a user zooms") {
    const Folder folder;
    json scene = json::parse(tumble::test::small_scene());
    scene["expect"] = json::parse(R"([{"body": "ball", "height": [-9, 60]}])");
    const std::string page = make_page(folder, folder.write("small.json", scene.dump()));
    // Pixels of lines that are drawn with dashes; the region of the claim is 20 km wide.
    const json found = browse({"ask", page, R"({ const p = replay.player, c = p.camera, lengths = [];
        p.showClaim(p.run.claims[0]);
        const line = p.overlays.line;
        p.overlays.line = (points, ...rest) => {
          const [a, b] = points.map((point) => c.pixels(...point));
          lengths.push(Math.hypot(b[0] - a[0], b[1] - a[1]));
          line.call(p.overlays, points, ...rest);
        };
        const longest = Math.hypot(c.width + 20, c.height + 20) + 1;
        p.on.joints = false;
        c.moveTo(0, -9);
        for (const scale of [1e-2, 1, 1e3, 1e6]) { c.scale = scale; p.draw(); }
        return [lengths.length > 3, lengths.every((length) => length <= longest)]; })"})
                           .at(0);
    CHECK(found == json::parse("[true, true]"));
}

TEST_CASE("static bodies are hatched as in frames, and the lines stay with the world") {
    const Folder folder;
    json scene = json::parse(tumble::test::small_scene());
    const std::string plain = make_page(folder, folder.write("plain.json", scene.dump()));
    scene["camera"]["style"] = json{{"hatching", true}};
    const std::string hatched = make_page(folder, folder.write("hatched.json", scene.dump()));
    // Pixels of the ground where px + py is that of the origin plus k lines of 12 sqrt 2, or half a line beside it:
    // how many have the colour of the body.
    const std::string ask = R"({ const p = replay.player, c = p.camera, context = p.painter.context, shares = [];
        p.setTheme("light");
        p.on.joints = false;
        for (const move of [[0, 0], [0.37, 0.11]]) {
          c.moveTo(move[0], move[1]);
          c.scale = 200;
          p.seek(0);
          p.draw();
          const [ox, oy] = c.pixels(0, 0), fill = p.painter.theme.paint(p.run.bodies[0].shapes[0][1], true, false).fill;
          const isFill = (x, y) => {
            const d = context.getImageData(Math.floor(x), Math.floor(y), 1, 1).data;
            return channels(fill).every((value, i) => Math.abs(value - d[i]) <= 1);
          };
          for (const beside of [0, 0.5]) {
            let plain = 0;
            for (let k = 1; k <= 20; k++) plain += isFill(ox + (k + beside) * 12 * Math.SQRT2 - 60, oy + 60);
            shares.push(plain);
          }
        }
        return shares; })";
    CHECK(browse({"ask", plain, ask}).at(0) == json::parse("[20, 20, 20, 20]"));
    CHECK(browse({"ask", hatched, ask}).at(0) == json::parse("[0, 20, 0, 20]"));
}
