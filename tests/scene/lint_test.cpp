// What `validate` warns of: each lint at its place with its reason, by the smallest scene that earns it, and by one beside
// it that does not.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tumble/scene_file.hpp"

using namespace tumble;

namespace {

std::vector<Diagnostic> warnings_of(const std::string& bodies, const std::string& rest = "") {
    std::vector<Diagnostic> warnings;
    parse_scene(R"({"format": 1, "bodies": [)" + bodies + "]" + rest + "}", "scene.json", {.overrides = {}, .seed = {}, .lint = true},
                &warnings);
    return warnings;
}

// The only warning.
Diagnostic warning_of(const std::string& bodies, const std::string& rest = "") {
    const std::vector<Diagnostic> warnings = warnings_of(bodies, rest);
    REQUIRE_MESSAGE(warnings.size() == 1, bodies << " has " << warnings.size() << " warnings");
    CHECK(warnings[0].severity == Diagnostic::Severity::warning);
    CHECK(!warnings[0].hint.empty());
    CHECK(warnings[0].line == 1);
    return warnings[0];
}

bool says(const Diagnostic& warning, const std::string& part) { return warning.message.find(part) != std::string::npos; }

const std::string kGround = R"({"type": "static", "position": [0, -0.5], "shapes": [{"box": {"size": [90, 1]}}]}, )";

}  // namespace

TEST_CASE("slivers and sizes out of range are warned of, on bodies that move") {
    const Diagnostic thin = warning_of(R"({"position": [0, 5], "shapes": [{"polygon": {"vertices": [[0, 0], [3, 1], [3, 1.02]]}}]})");
    CHECK(thin.pointer == "/bodies/0/shapes/0");
    CHECK(says(thin, "sliver"));
    CHECK(warnings_of(R"({"shapes": [{"box": {"size": [3, 0.04]}}]})").empty());
    CHECK(says(warning_of(R"({"shapes": [{"circle": {"radius": 0.002}}]})"), "is 0.004 m large"));
    CHECK(says(warning_of(R"({"shapes": [{"circle": {"radius": 60}}]})"), "is 120 m large"));
    CHECK(warnings_of(R"({"type": "static", "shapes": [{"box": {"size": [500, 0.1]}}]})").empty());
}

TEST_CASE("a body that moves farther in a step than it is thick is warned of, unless something keeps it from passing") {
    // 60 m/s at 60 Hz: 1 m a step; the ball is 0.5 m thick.
    const std::string target = R"({"position": [50, 0], "shapes": [{"box": {"size": [1, 1]}}]}, )";
    const std::string ball = R"({"velocity": [60, 0], "shapes": [{"circle": {"radius": 0.25}}])";
    const Diagnostic fast = warning_of(target + ball + "}");
    CHECK(fast.pointer == "/bodies/1/velocity");
    CHECK(says(fast, "is 1 m in a step, of a body 0.5 m thick"));
    CHECK(warnings_of(target + ball + R"(, "bullet": true})").empty());
    CHECK(warnings_of(target + ball + "}", R"(, "world": {"steps_per_second": 240})").empty());
    CHECK(says(warning_of(target + ball + R"(, "bullet": true})", R"(, "world": {"continuous": false})"), "not continuous"));
}

TEST_CASE("masses that differ by more than a hundred are warned of where they touch or are tied") {
    const std::string light = R"({"name": "light", "position": [0, 0.5], "shapes": [{"box": {"size": [1, 1]}}]}, )";
    // 1 kg under 4 x 4 x 10 = 160 kg.
    const std::string heavy = R"({"name": "heavy", "position": [0, 3], "shapes": [{"box": {"size": [4, 4]}, "material": "lead"}]})";
    const std::string lead = R"(, "materials": {"lead": {"density": 10}}, "world": {"gravity": [0, 0]})";
    const Diagnostic touching = warning_of(kGround + light + heavy, lead);
    CHECK(says(touching, "of 1 kg touches 'heavy' of 160 kg"));
    CHECK(warnings_of(kGround + light + heavy, R"(, "materials": {"lead": {"density": 6}}, "world": {"gravity": [0, 0]})").empty());
    const std::string far = R"({"name": "heavy", "position": [20, 3], "shapes": [{"box": {"size": [4, 4]}, "material": "lead"}]})";
    CHECK(warnings_of(kGround + light + far, lead).empty());
    const Diagnostic tied =
        warning_of(kGround + light + far, lead + R"(, "joints": [{"type": "revolute", "bodies": ["light", "heavy"], "anchor": [10, 1]}])");
    CHECK(tied.pointer == "/joints/0");
    CHECK(says(tied, "1 kg and 160 kg"));
}

TEST_CASE("bodies that start inside each other are warned of once for all copies") {
    const Diagnostic deep =
        warning_of(R"({"name": "crate", "position": [0, 5], "repeat": {"grid": {"columns": 4, "spacing": [0.9, 1]}}, "shapes": [{"box": {"size": [1, 1]}}]})");
    CHECK(deep.pointer == "/bodies/0");
    CHECK(says(deep, "'crate[1]' starts 0.1 m inside 'crate[0]'"));
    CHECK(warnings_of(R"({"repeat": {"grid": {"columns": 4, "spacing": [0.995, 1]}}, "shapes": [{"box": {"size": [1, 1]}}]})").empty());
}

TEST_CASE("a body asleep in the air is warned of, one that is held or where nothing falls is not") {
    const std::string sleeper = R"({"name": "lamp", "position": [0, HEIGHT], "awake": false, "shapes": [{"box": {"size": [1, 1]}}]})";
    const auto at = [&](const std::string& height) { return std::string(sleeper).replace(sleeper.find("HEIGHT"), 6, height); };
    CHECK(says(warning_of(kGround + at("3")), "'lamp' sleeps in the air"));
    CHECK(warnings_of(kGround + at("0.5")).empty());
    CHECK(warnings_of(kGround + at("3"), R"(, "world": {"gravity": [0, 0]})").empty());
}

TEST_CASE("a stack is said to sink by half of what the contact springs would give") {
    // Twenty unit boxes: sum over k < 20 of 2.5 k g / w^2 + 1.25 20 g / (4 w^2) = (475 + 6.25) g / w^2, w = 2 pi 30, by half: 0.0677 m.
    const Diagnostic stack =
        warning_of(kGround + R"({"name": "box", "position": [0, 0.5], "repeat": {"grid": {"rows": 20}}, "shapes": [{"box": {"size": [1, 1]}}]})");
    CHECK(stack.pointer == "/bodies/1");
    CHECK(says(stack, "'box[19]' stands on will sink by about 0.0677 m"));
    CHECK(warnings_of(kGround + R"({"position": [0, 0.5], "repeat": {"grid": {"rows": 6}}, "shapes": [{"box": {"size": [1, 1]}}]})").empty());
}

TEST_CASE("in a world of marbles sizes and sinking are those of marbles") {
    const std::string small = R"(, "world": {"scale": 0.02})";
    CHECK(warnings_of(R"({"shapes": [{"circle": {"radius": 0.002}}]})", small).empty());
    CHECK(says(warning_of(R"({"shapes": [{"circle": {"radius": 2}}]})", small), "between 0.0001 m and 2 m"));
    // At the step rate of the scale, 60 / sqrt(0.02), frequencies follow its inverse root, so that 20 boxes of 2 cm sink by a
    // fiftieth of 0.0677 m. At the usual rate they stay at an eighth of the sub-steps', 30 Hz, and all of the 0.0677 m is left.
    const std::string ground = R"({"type": "static", "position": [0, -0.01], "shapes": [{"box": {"size": [1.8, 0.02]}}]}, )";
    const std::string tower =
        R"({"position": [0, 0.01], "repeat": {"grid": {"rows": 20, "spacing": [1, 0.02]}}, "shapes": [{"box": {"size": [0.02, 0.02]}}]})";
    const std::string quick = R"(, "world": {"scale": 0.02, "steps_per_second": 424.264})";
    CHECK(says(warning_of(ground + tower, quick), "will sink by about 0.00135 m"));
    CHECK(says(warning_of(ground + tower, small), "will sink by about 0.0677 m"));
}

TEST_CASE("lints are made on request alone") {
    std::vector<Diagnostic> warnings;
    parse_scene(R"({"format": 1, "bodies": [{"shapes": [{"circle": {"radius": 0.002}}]}]})", "scene.json", &warnings);
    CHECK(warnings.empty());
}
