// The warnings of `validate`: for each lint the smallest scene that causes it, with its location and reason, and a
// similar scene without a warning.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "scene/warnings.hpp"
#include "support/temporary_folder.hpp"

using namespace tumble;
using test::says;
using test::warning_of;
using test::warnings_of;

namespace {

const std::string kGround = R"({"type": "static", "position": [0, -0.5], "shapes": [{"box": {"size": [90, 1]}}]}, )";

}  // namespace

TEST_CASE("slivers and sizes out of range cause a warning, on dynamic bodies only") {
    const Diagnostic thin =
        warning_of(R"({"position": [0, 5], "shapes": [{"polygon": {"vertices": [[0, 0], [3, 1], [3, 1.02]]}}]})");
    CHECK(thin.pointer == "/bodies/0/shapes/0");
    CHECK(says(thin, "sliver"));
    CHECK(warnings_of(R"({"shapes": [{"box": {"size": [3, 0.04]}}]})").empty());
    // A block with a thin ledge is cut into a thick and a thin part, and is no sliver; a thin corner of two parts is
    // one.
    const auto outline = [](const std::string& points) {
        return warnings_of(R"({"position": [0, 5], "shapes": [{"outline": {"points": )" + points + "}}]}");
    };
    CHECK(outline("[[0, 0], [3, 0], [3, 0.02], [1, 0.02], [1, 1], [0, 1]]").empty());
    CHECK(outline("[[0, 0], [3, 0], [3, 0.01], [0.01, 0.01], [0.01, 3], [0, 3]]").size() == 1);
    CHECK(says(warning_of(R"({"shapes": [{"circle": {"radius": 0.002}}]})"), "is 0.004 m large"));
    CHECK(says(warning_of(R"({"shapes": [{"circle": {"radius": 60}}]})"), "is 120 m large"));
    CHECK(warnings_of(R"({"type": "static", "shapes": [{"box": {"size": [500, 0.1]}}]})").empty());
}

TEST_CASE("a mass of a body that is not dynamic causes a warning") {
    const auto with_mass = [](const std::string& type) {
        return warnings_of(R"({"type": ")" + type + R"(", "position": [0, 5], "mass": {"mass": 3, "inertia": 1},
            "shapes": [{"box": {"size": [2, 1]}}]})");
    };
    for (const char* type : {"static", "kinematic"}) {
        REQUIRE(with_mass(type).size() == 1);
        CHECK(with_mass(type)[0].pointer == "/bodies/0/mass");
        CHECK(says(with_mass(type)[0], "its mass has no effect"));
    }
    CHECK(with_mass("dynamic").empty());
}

TEST_CASE("an angle that people often write in radians causes a warning, one that is meant in degrees does not") {
    const auto turned = [](const char* angle) {
        return warnings_of(std::string(R"({"position": [0, 5], "angle": )") + angle +
                           R"(, "shapes": [{"box": {"size": [2, 1]}}]})");
    };
    for (const char* const radians : {"1.57", "-1.5708", "3.14", "0.785", "6.2832", "1.0471975511965976"}) {
        CAPTURE(radians);
        REQUIRE(turned(radians).size() == 1);
        CHECK(turned(radians)[0].pointer == "/bodies/0/angle");
        CHECK(says(turned(radians)[0], "looks like one in radians"));
    }
    CHECK(turned("-1.57")[0].hint == "if it is meant in radians, write -90");
    for (const char* const degrees :
         {"0", "0.2618", "1.309", "1.5", "1.6", "3", "5.5", "11", "45", "90", "1.5712345678"})
        CHECK(turned(degrees).empty());
}

TEST_CASE("a hinge that starts out of its range causes a warning") {
    const auto hinge = [](const std::string& keys) {
        return warnings_of(
            R"({"name": "a", "type": "static"}, {"name": "b", "shapes": [{"box": {"size": [2, 1]}}]})",
            R"(, "joints": [{"type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], )" + keys + "}]");
    };
    const std::vector<Diagnostic> outside = hinge(R"("limits": [10, 50])");
    REQUIRE(outside.size() == 1);
    CHECK(outside[0].pointer == "/joints/0");
    CHECK(says(outside[0], "starts at 0 degrees, outside of its limits"));
    CHECK(hinge(R"("limits": [10, 50], "reference_angle": -30)").empty());
    CHECK(hinge(R"("limits": [-50, -10])").size() == 1);
    CHECK(hinge(R"("limits": [-50, 10])").empty());
    CHECK(hinge(R"("limits": [2, 50])").empty());
    const std::vector<Diagnostic> radians = hinge(R"("limits": [-1.57, 0])");
    REQUIRE(radians.size() == 1);
    CHECK(radians[0].pointer == "/joints/0/limits/0");
}

TEST_CASE("images without their files cause a warning, one for each file") {
    const TemporaryFolder folder;
    std::ofstream(folder.path / "there.png") << "";
    const std::string images = R"("images": [{"file": "there.png", "height": 1}, {"file": "gone.png", "height": 1}])";
    std::ofstream(folder.path / "scene.json") << R"({"format": 1, "bodies": [{)" + images + "}, {" + images + "}]}";
    std::vector<Diagnostic> warnings;
    load_scene(folder.path / "scene.json", {.overrides = {}, .seed = {}, .lint = true}, &warnings);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].pointer == "/bodies/0/images/1/file");
    CHECK(says(warnings[0], "gone.png\": frames show the outline"));
}

TEST_CASE("an image that is there and cannot be read causes another warning than one that is not") {
    const TemporaryFolder folder;
    std::filesystem::create_symlink("loop.png", folder.path / "loop.png");  // fails for every user, as root too
    std::filesystem::create_directory(folder.path / "folder.png");
    mkfifo((folder.path / "pipe.png").c_str(), 0600);
    std::ofstream(folder.path / "text.png") << "text";
    const auto warning_about = [&](const std::string& file) {
        std::ofstream(folder.path / "scene.json")
            << R"({"format": 1, "bodies": [{"images": [{"file": ")" + file + R"(", "height": 1}]}]})";
        std::vector<Diagnostic> warnings;
        load_scene(folder.path / "scene.json", {.overrides = {}, .seed = {}, .lint = true}, &warnings);
        REQUIRE(warnings.size() == 1);
        CHECK(warnings[0].code == "missing-image");
        return warnings[0];
    };
    CHECK(says(warning_about("loop.png"),
               "loop.png\" cannot be read (Too many levels of symbolic links): no frames can be drawn"));
    CHECK(says(warning_about("folder.png"), "folder.png\" is a folder, not a file: no frames can be drawn"));
    CHECK(says(warning_about("pipe.png"), "pipe.png\" is no regular file: no frames can be drawn"));
    CHECK(says(warning_about("text.png/a.png"), "there is no file"));
}

TEST_CASE("a chain with a body on its solid side causes a warning, one with a body on its open side does not") {
    const auto on_chain = [](const std::string& points, const std::string& more = "") {
        return warnings_of(
            R"({"name": "hills", "type": "static", "shapes": [{"circle": {"radius": 0.1}}, {"chain": {"points": )" +
            points + more + R"(}}]}, {"name": "car", "position": [2, 3], "shapes": [{"circle": {"radius": 0.5}}]})");
    };
    const std::string to_the_right = "[[-9, 0], [0, 0], [9, 1]]", to_the_left = "[[9, 1], [0, 0], [-9, 0]]";
    const std::vector<Diagnostic> wrong = on_chain(to_the_right);
    REQUIRE(wrong.size() == 1);
    CHECK(wrong[0].pointer == "/bodies/0/shapes/1/chain/points");
    CHECK(says(wrong[0], "'car' starts on the solid side of the chain"));
    CHECK(on_chain(to_the_left).empty());
    CHECK(on_chain(to_the_right, R"(, "two_sided": true)").empty());
    // A block below the car, and a room around it.
    CHECK(on_chain("[[0, 0], [4, 0], [4, 1], [0, 1]]", R"(, "loop": true)").empty());
    CHECK(on_chain("[[0, 0], [0, 9], [4, 9], [4, 0]]", R"(, "loop": true)").empty());
    CHECK(on_chain("[[0, 0], [4, 0], [4, 9], [0, 9]]", R"(, "loop": true)").size() == 1);
    // A nearer shape supports the car.
    CHECK(warnings_of(R"({"name": "hills", "type": "static", "shapes": [{"chain": {"points": )" + to_the_right +
                      R"(}}, {"box": {"size": [9, 1], "center": [0, 1.5]}}]},
        {"name": "car", "position": [2, 3], "shapes": [{"circle": {"radius": 0.5}}]})")
              .empty());
}

TEST_CASE("joints that start apart or act far away, and springs too stiff for the steps, cause a warning") {
    const std::string bodies =
        R"({"name": "a", "shapes": [{"box": {"size": [1, 1]}}]}, {"name": "b", "position": [8, 0], "shapes": [{"box": {"size": [1, 1]}}]})";
    const auto joined = [](const std::string& joint) {
        return R"(, "world": {"gravity": [0, 0]}, "joints": [{"bodies": ["a", "b"], )" + joint + "}]";
    };
    const std::string rod = R"("type": "distance", "anchors": [[0, 0], [0, 0]])";
    CHECK(says(warning_of(bodies, joined(rod + R"(, "length": 30)")),
               "starts 22 m away from a position that it allows for 'a' and 'b'"));
    CHECK(warnings_of(bodies, joined(rod + R"(, "length": 8.05)")).empty());
    CHECK(warnings_of(bodies, joined(rod + R"(, "limits": [0, 9])")).empty());
    CHECK(warnings_of(bodies, joined(rod + R"(, "length": 30, "spring": {"hertz": 2})")).empty());
    CHECK(says(warning_of(bodies, joined(R"("type": "revolute", "anchor": [50, 50])")),
               "acts at [50, 50], far from both 'a' and 'b'"));
    CHECK(warnings_of(bodies, joined(R"("type": "revolute", "anchor": [0, -9])")).empty());
    // 0.15 of 240 sub-steps a second.
    const Diagnostic stiff = warning_of(bodies, joined(rod + R"(, "spring": {"hertz": 36.5})"));
    CHECK(stiff.pointer == "/joints/0/spring/hertz");
    CHECK(says(stiff, "is limited to 36 Hz"));
    CHECK(warnings_of(bodies, joined(rod + R"(, "spring": {"hertz": 36})")).empty());
}

TEST_CASE("copies of a rod that all end at one point of a body cause a warning, unless they are spokes") {
    // Rods from the middle of the beam, at [0, 4], to balls at x = 0, 1 and 2 on the line y = 0: the longest sqrt(20)
    // m.
    const std::string beam =
        R"({"name": "beam", "type": "static", "position": [0, 4], "shapes": [{"box": {"size": [9, 1]}}]}, )";
    const std::string balls =
        R"({"name": "ball", "repeat": {"grid": {"columns": 3}}, "shapes": [{"circle": {"radius": 0.4}}]})";
    const auto joint = [](const std::string& from, const std::string& to, const std::string& more) {
        return R"(, "joints": [{"type": "distance", "bodies": [")" + from + "\", \"" + to +
               R"("], "anchors": [[0, 0], [0, 0]]})" + more + "]";
    };
    const auto repeated = [&](const std::string& from, const std::string& to) {
        std::string text = joint(from, to, "");
        return text.replace(text.rfind('}'), 1, R"(, "repeat": {"columns": 3}})");
    };
    for (const std::string& rods : {repeated("beam", "ball[0]"), repeated("ball[0]", "beam")}) {
        const Diagnostic shared = warning_of(beam + balls, rods);
        CHECK(shared.pointer == "/joints/0/repeat");
        CHECK(says(shared, "one point of 'beam', which is not repeated: they are from 4 to 4.47 m long"));
    }
    CHECK(warning_of(beam + balls, repeated("beam", "ball[0]")).hint.starts_with("give \"repeat\" a \"spacing\""));
    CHECK(warnings_of(beam + balls, joint("beam", "ball[0]", "")).empty());
    std::string spaced = repeated("beam", "ball[0]");
    spaced.replace(spaced.find(R"("columns": 3)"), 12, R"("columns": 3, "spacing": [1, 0])");
    CHECK(warnings_of(beam + balls, spaced).empty());
    // One hook for each ball, and spokes of equal length.
    const std::string hooks =
        R"({"name": "hook", "type": "static", "position": [0, 4], "repeat": {"grid": {"columns": 3}}}, )";
    CHECK(warnings_of(hooks + balls, repeated("hook[0]", "ball[0]")).empty());
    const std::string ring =
        R"({"name": "ball", "position": [0, 4], "repeat": {"ring": {"count": 3, "radius": 7}}, "shapes": [{"circle": {"radius": 0.4}}]})";
    CHECK(warnings_of(beam + ring, repeated("beam", "ball[0]")).empty());
}

TEST_CASE("events and claims after the end of the run, and events without effect, cause a warning") {
    const std::string bodies =
        R"({"name": "ball", "shapes": [{"circle": {"radius": 0.5}}]}, {"name": "wall", "type": "static", "position": [9, 0]},
        {"name": "lift", "type": "kinematic", "position": [-9, 0], "shapes": [{"box": {"size": [1, 1]}}]})";
    const auto event = [](const std::string& text) {
        return R"(, "world": {"duration": 3}, "timeline": [)" + text + "]";
    };
    const auto claim = [](const std::string& text) {
        return R"(, "world": {"duration": 3}, "expect": [)" + text + "]";
    };
    CHECK(says(warning_of(bodies, event(R"({"at": 3, "gravity": [0, 0]})")),
               "the run ends at 3 s: the event never happens"));
    CHECK(warnings_of(bodies, event(R"({"at": 2.98, "gravity": [0, 0]})")).empty());
    CHECK(warning_of(bodies, event(R"({"every": 1, "from": 4, "gravity": [0, 0]})")).pointer == "/timeline/0/from");
    CHECK(says(warning_of(bodies, claim(R"({"at_rest_by": 3.1})")), "the run ends at 3 s: the claim cannot hold"));
    CHECK(warnings_of(bodies, claim(R"({"at_rest_by": 3})")).empty());
    CHECK(warning_of(bodies, claim(R"({"body": "ball", "height": [0, 1], "at": 8})")).pointer == "/expect/0/at");
    CHECK(says(warning_of(bodies, event(R"({"at": 1, "body": "wall", "impulse": [1, 0]})")), "is static"));
    CHECK(says(warning_of(bodies, event(R"({"at": 1, "body": "lift", "torque": 1})")), "is kinematic"));
    CHECK(warnings_of(bodies,
                      event(R"({"at": 1, "body": "lift", "velocity": [1, 0]}, {"at": 1, "body": "ball", "torque": 1})"))
              .empty());
    const Diagnostic gone =
        warning_of(bodies, event(R"({"at": 2, "body": "ball", "impulse": [1, 0]}, {"at": 1, "despawn": "ball"})"));
    CHECK(gone.pointer == "/timeline/0/body");
    CHECK(says(gone, "is removed at 1 s"));
    // The spawned body and the joint have the same name. A released joint is gone; a body that the timeline spawns is
    // not reported.
    const std::string late = R"({"at": 0.5, "spawn": {"name": "hinge", "position": [0, 9]}}, {"at": 1, )";
    const auto hinged = [&](const std::string& end) {
        return R"(, "joints": [{"type": "revolute", "name": "hinge", "bodies": ["wall", "ball"], "anchor": [9, 0], "motor": {"speed": 1, "max_torque": 1}}])" +
               event(late + end);
    };
    CHECK(warning_of(bodies, hinged(R"("release": "hinge"}, {"at": 2, "joint": "hinge", "motor_speed": 0})")).pointer ==
          "/timeline/2/joint");
    CHECK(warnings_of(bodies, hinged(R"("despawn": "hinge"}, {"at": 2, "body": "hinge", "impulse": [1, 0]})")).empty());
}

TEST_CASE("bodies of segments and sensors alone cause a warning, because they have no mass") {
    CHECK(says(warning_of(R"({"shapes": [{"segment": {"from": [0, 0], "to": [1, 0]}}]})"),
               "gets 1 kg and does not rotate"));
    CHECK(says(warning_of(R"({"shapes": [{"circle": {"radius": 1}, "sensor": true}]})"), "which have no mass"));
    CHECK(warnings_of(R"({"shapes": [{"segment": {"from": [0, 0], "to": [1, 0]}}], "mass": {"mass": 2, "inertia": 1}})")
              .empty());
    CHECK(warnings_of(R"({"name": "pin"}, {"type": "static", "shapes": [{"segment": {"from": [0, 0], "to": [1, 0]}}]})")
              .empty());
}

TEST_CASE("a static body with a velocity causes a warning") {
    CHECK(says(warning_of(R"({"type": "static", "velocity": [1, 0], "shapes": [{"circle": {"radius": 1}}]})"),
               "it does not move"));
    CHECK(warnings_of(R"({"type": "kinematic", "velocity": [1, 0], "shapes": [{"circle": {"radius": 1}}]})").empty());
}

TEST_CASE("masses of a ratio above a hundred cause a warning where they touch or are joined") {
    const std::string light = R"({"name": "light", "position": [0, 0.5], "shapes": [{"box": {"size": [1, 1]}}]}, )";
    // 1 kg under 4 x 4 x 10 = 160 kg.
    const std::string heavy =
        R"({"name": "heavy", "position": [0, 3], "shapes": [{"box": {"size": [4, 4]}, "material": "lead"}]})";
    const std::string lead = R"(, "materials": {"lead": {"density": 10}}, "world": {"gravity": [0, 0]})";
    const Diagnostic touching = warning_of(kGround + light + heavy, lead);
    CHECK(says(touching, "of 1 kg touches 'heavy' of 160 kg"));
    CHECK(
        warnings_of(kGround + light + heavy, R"(, "materials": {"lead": {"density": 6}}, "world": {"gravity": [0, 0]})")
            .empty());
    const std::string far =
        R"({"name": "heavy", "position": [20, 3], "shapes": [{"box": {"size": [4, 4]}, "material": "lead"}]})";
    CHECK(warnings_of(kGround + light + far, lead).empty());
    const Diagnostic joined =
        warning_of(kGround + light + far,
                   lead + R"(, "joints": [{"type": "revolute", "bodies": ["light", "heavy"], "anchor": [10, 1]}])");
    CHECK(joined.pointer == "/joints/0");
    CHECK(says(joined, "1 kg and 160 kg"));
}

TEST_CASE("bodies that start inside each other cause one warning for all copies") {
    const Diagnostic deep = warning_of(
        R"({"name": "crate", "position": [0, 5], "repeat": {"grid": {"columns": 4, "spacing": [0.9, 1]}}, "shapes": [{"box": {"size": [1, 1]}}]})");
    CHECK(deep.pointer == "/bodies/0");
    CHECK(says(deep, "'crate[1]' starts 0.1 m inside 'crate[0]'"));
    CHECK(warnings_of(
              R"({"repeat": {"grid": {"columns": 4, "spacing": [0.995, 1]}}, "shapes": [{"box": {"size": [1, 1]}}]})")
              .empty());
}

TEST_CASE("a body that sleeps without support causes a warning, one with support or without gravity does not") {
    const std::string sleeper =
        R"({"name": "lamp", "position": [0, HEIGHT], "awake": false, "shapes": [{"box": {"size": [1, 1]}}]})";
    const auto at = [&](const std::string& height) {
        return std::string(sleeper).replace(sleeper.find("HEIGHT"), 6, height);
    };
    CHECK(says(warning_of(kGround + at("3")), "'lamp' starts asleep without support"));
    CHECK(warnings_of(kGround + at("0.5")).empty());
    CHECK(warnings_of(kGround + at("3"), R"(, "world": {"gravity": [0, 0]})").empty());
}

TEST_CASE("a stack is predicted to sink by what the contact springs yield") {
    // Twenty unit boxes: sum over k < 20 of 2.5 k g / w^2 + 1.25 20 g / (4 w^2) = (475 + 6.25) g / w^2, w = 2 pi
    // 42.6: 0.0672 m.
    const Diagnostic stack = warning_of(
        kGround +
        R"({"name": "box", "position": [0, 0.5], "repeat": {"grid": {"rows": 20}}, "shapes": [{"box": {"size": [1, 1]}}]})");
    CHECK(stack.pointer == "/bodies/1");
    CHECK(says(stack, "the support of 'box[19]' ('box[18]') will sink by about 0.0672 m"));
    // The warning names other piles too, one of those that are equal.
    const auto pile = [](const std::string& name, const std::string& at) {
        return R"(, {"name": ")" + name + R"(", "position": [)" + at +
               R"(, 0.5], "repeat": {"grid": {"columns": 2, "rows": 20, "spacing": [3, 1]}}, "shapes": [{"box": {"size": [1, 1]}}]})";
    };
    CHECK(says(warning_of(kGround.substr(0, kGround.rfind(',')) + pile("a", "0") + pile("b", "9")),
               "by about 0.0672 m under the weight on it, that of 'b[38]' by about 0.0672 m"));
    // 1 kg on a feather of 2.5 g: 400 times its load.
    const std::string feather =
        R"({"name": "feather", "position": [0, 0.25], "shapes": [{"box": {"size": [0.5, 0.5]}, "material": "f"}]}, )";
    const std::vector<Diagnostic> crushed = warnings_of(
        kGround + feather +
            R"({"name": "anvil", "position": [0, 1], "shapes": [{"box": {"size": [1, 1]}, "material": "a"}]})",
        R"(, "materials": {"f": {"density": 0.01}, "a": {"density": 5000}})");
    CHECK(std::ranges::any_of(crushed, [](const Diagnostic& warning) {
        return says(warning, "the support of 'anvil' ('feather') will sink by more than the size of the body");
    }));
    CHECK(
        warnings_of(kGround +
                    R"({"position": [0, 0.5], "repeat": {"grid": {"rows": 6}}, "shapes": [{"box": {"size": [1, 1]}}]})")
            .empty());
}

TEST_CASE("the limits of sizes and sinking follow the scale of the world") {
    const std::string small = R"(, "world": {"scale": 0.02})";
    CHECK(warnings_of(R"({"shapes": [{"circle": {"radius": 0.002}}]})", small).empty());
    CHECK(says(warning_of(R"({"shapes": [{"circle": {"radius": 2}}]})", small), "between 0.0001 m and 2 m"));
    // At the step rate of the scale, 60 / sqrt(0.02), frequencies follow its inverse root, so that 20 boxes of 2 cm
    // sink by a fiftieth of 0.0672 m. At the usual rate they stay at 0.1775 of the sub-steps', 42.6 Hz, and all of the
    // 0.0672 m is left, three boxes high.
    const std::string ground =
        R"({"type": "static", "position": [0, -0.01], "shapes": [{"box": {"size": [1.8, 0.02]}}]}, )";
    const std::string tower =
        R"({"position": [0, 0.01], "repeat": {"grid": {"rows": 20, "spacing": [1, 0.02]}}, "shapes": [{"box": {"size": [0.02, 0.02]}}]})";
    const std::string quick = R"(, "world": {"scale": 0.02, "steps_per_second": 424.264})";
    CHECK(says(warning_of(ground + tower, quick), "will sink by about 0.00134 m"));
    CHECK(says(warning_of(ground + tower, small), "will sink by more than the size of the body"));
}

TEST_CASE("lints are made on request alone") {
    std::vector<Diagnostic> warnings;
    parse_scene(R"({"format": 1, "bodies": [{"shapes": [{"circle": {"radius": 0.002}}]}]})", "scene.json", &warnings);
    CHECK(warnings.empty());
}

TEST_CASE("elastic bodies that touch two others cause a warning if impacts happen at the step's end") {
    const auto row = [](const std::string& restitution, const std::string& spacing) {
        return R"({"name": "ball", "repeat": {"grid": {"columns": 3, "spacing": [)" + spacing +
               R"(, 0]}}, "shapes": [{"circle": {"radius": 0.5}, "material": ")" + restitution + R"("}]})";
    };
    const std::string materials = R"(, "materials": {"steel": {"restitution": 1}, "clay": {"restitution": 0}})",
                      at_end = materials + R"(, "world": {"impacts": "at_step_end", "gravity": [0, 0]})";
    const Diagnostic warning = warning_of(row("steel", "1"), at_end);
    CHECK(warning.code == "spread-impact");
    CHECK(says(warning, "'ball[1]' touches two elastic bodies"));
    CHECK(warning.hint.find("in_order") != std::string::npos);
    CHECK(warnings_of(row("steel", "1"), materials + R"(, "world": {"gravity": [0, 0]})").empty());
    CHECK(warnings_of(row("clay", "1"), at_end).empty());
    CHECK(warnings_of(row("steel", "1.03"), at_end).empty());
    const std::string two = row("steel", "1");
    CHECK(warnings_of(std::string(two).replace(two.find("3, \"spacing"), 1, "2"), at_end).empty());
}
