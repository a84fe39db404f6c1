// The health of runs: each planted fault is found and its culprit named, sound scenes have no findings, and watching
// changes nothing.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "scene/shipped.hpp"
#include "scene/unhealthy_scenes.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;

namespace {

struct WatchedRun {
    std::vector<HealthFinding> findings;
    std::vector<HealthSample> samples;
    std::uint64_t state_hash = 0;
};

WatchedRun watch_run(const Scene& scene) {
    SceneRun run(scene);
    HealthWatch watch(scene);
    watch.observe(run.built());
    for (std::uint64_t step = count_steps(scene); step > 0 && !run.is_stopped(); --step) {
        run.step();
        watch.observe(run.built());
    }
    return {watch.findings(), watch.samples(), run.world().state_hash()};
}

std::string words_of(const std::vector<HealthFinding>& findings) {
    std::string text;
    for (const HealthFinding& finding : findings) text += finding.check + ": " + finding.text + "\n";
    return text;
}

// Its name as a message quotes it.
bool names(const HealthFinding& finding, const std::string& culprit) {
    return (finding.subject + " " + finding.text).find("'" + culprit + "'") != std::string::npos;
}

// What a shipped scene shows on purpose.
const std::map<std::string, std::set<std::string>> kOnPurpose{{"overlap_recovery", {"overlap", "energy"}}};

}  // namespace

TEST_CASE("the report of each planted fault names its culprit") {
    const std::vector<test::UnhealthyScene> scenes = test::unhealthy_scenes();
    REQUIRE(scenes.size() >= 20);
    std::set<std::string> checks;
    for (const test::UnhealthyScene& unhealthy : scenes) {
        const std::string& fault = unhealthy.fault;
        CAPTURE(fault);
        const WatchedRun run = watch_run(parse_scene(test::text_of(unhealthy), "unhealthy.json"));
        const bool is_found = std::ranges::any_of(run.findings, [&](const HealthFinding& finding) {
            return finding.check == unhealthy.check && names(finding, unhealthy.culprit);
        });
        CHECK_MESSAGE(is_found, words_of(run.findings));
        checks.insert(unhealthy.check);
    }
    CHECK(checks.size() == kHealthChecks.size());
}

TEST_CASE("shipped scenes have no findings, except for what they show on purpose") {
    for (const std::filesystem::path& file : test::shipped_scenes()) {
        CAPTURE(file);
        const auto allowed = kOnPurpose.find(file.stem());
        std::set<std::string> found;
        for (const HealthFinding& finding : watch_run(load_scene(file)).findings) {
            found.insert(finding.check);
            if (allowed == kOnPurpose.end()) FAIL_CHECK(finding.text);
        }
        if (allowed != kOnPurpose.end()) CHECK(found == allowed->second);
    }
}

TEST_CASE("gravity, damping, rotation, rounding, and loads from the side and from above are no faults") {
    const std::string empty = R"({"format": 1, "name": "sound", "materials":
        {"wood": {}, "stone": {"density": 120}, "iron": {"density": 200}}, "world": {"duration": 2)";
    const std::string floor =
        R"({"name": "floor", "type": "static", "position": [0, -0.5], "shapes": [{"box": {"size": [40, 1]}}]}, )";
    const std::string pea = test::ball("pea", "[0, 2]", "0.005", "wood");
    const std::vector<std::string> scenes{
        // A step adds 10 / 30 = 0.33 m/s, and a pea of 1 cm that moves by its thickness has 0.3 m/s.
        R"(, "steps_per_second": 30}, "bodies": [)" + pea + "]}",
        // Damping takes 0.5 / 60 of 100 m/s = 0.83 m/s; the thickness of each step is 0.6 m/s.
        R"(}, "bodies": [)" +
            test::ball("shot", "[0, 2]", "0.005", "wood", R"(, "velocity": [100, 0], "linear_damping": 0.5)") + "]}",
        // Pushed apart without gravity, by rounding alone.
        R"(, "gravity": [0, 0]}, "bodies": [)" + test::box("a", "[0, 0]", "[1, 1]", "wood") + ", " +
            test::box("b", "[0.992, 0]", "[1, 1]", "wood") + "]}",
        // The tip of a vane moves on a circle of 2 m, by 39.7 degrees in a step; its chords come as near to the centre
        // as 2 cos(19.9 degrees) = 1.88 m, across the post, whose farthest corner is at 1.916 m.
        R"(, "gravity": [0, 0]}, "bodies": [
            {"name": "post", "type": "static", "position": [1.9, 0], "shapes": [{"box": {"size": [0.03, 0.03]}}]},
            {"name": "fan", "angular_velocity": 2383, "shapes": [
              {"box": {"size": [0.03, 0.03], "center": [2, 0]}}, {"box": {"size": [0.03, 0.03], "center": [-2, 0]}}]}]})",
        // A finger of 0.5 kg presses with 700 N, 140 times its weight, on a crate of 200 kg, whose friction is 1200 N.
        R"(}, "bodies": [)" + floor + test::box("crate", "[0, 0.5]", "[1, 1]", "iron") + ", " +
            test::box("finger", "[-1, 0.5]", "[1, 0.5]", "wood", R"(, "gravity_scale": 0)") +
            R"(], "timeline": [{"at": 0, "body": "finger", "force": [700, 0]}]})",
        // A cushion of 1 kg carries two safes of 60 kg, and loads a plate of 400 kg below it with 121 times its weight.
        R"(}, "bodies": [)" + floor + test::box("plate", "[0, 0.25]", "[4, 0.5]", "iron") + ", " +
            test::box("cushion", "[0, 1]", "[1, 1]", "wood") + ", " +
            test::box("left safe", "[-0.26, 2]", "[0.5, 1]", "stone") + ", " +
            test::box("right safe", "[0.26, 2]", "[0.5, 1]", "stone") + "]}",
    };
    for (const std::string& rest : scenes) {
        const std::string text = empty + rest;
        CAPTURE(text);
        const std::vector<HealthFinding> findings = watch_run(parse_scene(text, "sound.json")).findings;
        CHECK_MESSAGE(findings.empty(), words_of(findings));
    }
}

TEST_CASE("a kinematic body that turns keeps awake what rests on it") {
    const test::UnhealthyScene turning{
        .fault = "",
        .check = "",
        .culprit = "",
        .rest = "",
        .bodies = test::ball("disc", "[0, 1]", "0.5", "ice", R"(, "type": "kinematic", "angular_velocity": 20)") +
                  ", " + test::box("crate", "[0, 1.75]", "[0.5, 0.5]", "ice")};
    const std::string words = words_of(watch_run(parse_scene(test::text_of(turning), "turning.json")).findings);
    CHECK_MESSAGE(words.find("'disc' is kinematic and turns at 20 degrees/s") != std::string::npos, words);
}

TEST_CASE("a watch that has seen no state has no findings") { CHECK(HealthWatch(Scene{}).findings().empty()); }

TEST_CASE("a body that is spawned below the grounds in a step that diverges is in no finding") {
    const std::string crate = test::box("crate", "[0, 0.5]", "[1, 1]", "wood");
    const test::UnhealthyScene spawning{
        .fault = "",
        .check = "",
        .culprit = "",
        .rest = R"("timeline": [{"at": 1, "spawn": )" + test::box("late", "[0, -500]", "[1, 1]", "wood") + "}]",
        .bodies = crate};
    const Scene scene = parse_scene(test::text_of(spawning), "spawning.json");
    SceneRun run(scene);
    HealthWatch watch(scene);
    watch.observe(run.built());
    while (run.built().bodies.size() == 3) run.step();  // not observed, as the step that throws
    CHECK_MESSAGE(watch.findings().empty(), words_of(watch.findings()));
}

TEST_CASE("watching a run does not change it") {
    for (const test::UnhealthyScene& unhealthy : test::unhealthy_scenes()) {
        const Scene scene = parse_scene(test::text_of(unhealthy), "unhealthy.json");
        SceneRun run(scene);
        for (std::uint64_t step = count_steps(scene); step > 0; --step) run.step();
        CHECK(watch_run(scene).state_hash == run.world().state_hash());
    }
}

TEST_CASE("bodies that a program adds to a run are no part of its health") {
    const std::string crate = test::box("crate", "[0, 0.5]", "[1, 1]", "wood");
    const test::UnhealthyScene alone{.fault = "", .check = "", .culprit = "", .rest = "", .bodies = crate};
    const Scene scene = parse_scene(test::text_of(alone), "alone.json");
    SceneRun run(scene);
    HealthWatch watch(scene);
    watch.observe(run.built());
    const BodyId added = run.world().create_body({.pose = {{0.2, 0.7}, {}}, .allow_sleep = false});
    run.world().add_shape(added, {.shape = make_box({1.0f, 1.0f})});
    for (std::uint64_t step = count_steps(scene); step > 0; --step) {
        run.step();
        watch.observe(run.built());
    }
    CHECK_MESSAGE(watch.findings().empty(), words_of(watch.findings()));
}
