// Claims that are conditions on states, and on the order of states.
#include <doctest/doctest.h>

#include <string>

#include "scene/disc_scene.hpp"
#include "scene/judge.hpp"

using namespace tumble;
using test::judge;
using test::make_disc_scene;

TEST_CASE("a condition is a claim on a state") {
    const std::string kick = R"("timeline": [{"at": 0.5, "body": "disc", "velocity": [1, 0]}], )";
    const auto judge_that = [&](const std::string& claim) {
        return judge(make_disc_scene(kick + R"("expect": [)" + claim + "]"), 120);
    };
    CHECK(judge_that(R"({"that": "disc.x > 1.4"})").passed);
    const ExpectationResult end = judge_that(R"({"that": "disc.x > 1.6"})");
    CHECK_FALSE(end.passed);
    CHECK(end.claim == "disc.x > 1.6 at the end");
    CHECK(end.finding == "disc.x is 1.5");
    CHECK(judge_that(R"({"that": "disc.vx == 0", "at": 0.4})").passed);
    CHECK(judge_that(R"({"that": "disc.vx == 1", "when": "always", "from": 0.6})").passed);
    CHECK(judge_that(R"({"that": "disc.x > 0.5 and disc.x < 0.6", "when": "sometime"})").passed);
    // The worst state decides: that of the end.
    const ExpectationResult always = judge_that(R"({"that": "disc.x < 1", "when": "always"})");
    CHECK_FALSE(always.passed);
    CHECK(always.step == 120);
    CHECK(judge_that(R"({"that": "disc.x > -0.6", "frame": {"position": [2, 0]}})").passed);
    CHECK_FALSE(judge_that(R"({"that": "disc.x > -0.4", "frame": {"position": [2, 0]}})").passed);
}

TEST_CASE("a claim on an order holds if the first condition holds before the second") {
    const std::string kick = R"("timeline": [{"at": 0.5, "body": "disc", "velocity": [1, 0]}], )";
    const auto judge_that = [&](const std::string& claim) {
        return judge(make_disc_scene(kick + R"("expect": [)" + claim + "]"), 120);
    };
    CHECK(judge_that(R"({"that": "disc.x > 0.4", "before": "disc.x > 0.6"})").passed);
    CHECK(judge_that(R"({"that": "disc.x > 0.4", "before": "disc.x > 60"})").passed);
    const ExpectationResult late = judge_that(R"({"that": "disc.x > 0.995", "before": "time >= 1"})");
    CHECK_FALSE(late.passed);
    CHECK(late.finding == "'disc.x > 0.995' holds first at 1.5 s, 'time >= 1' holds first at 1 s");
    CHECK_FALSE(judge_that(R"({"that": "disc.x > 9", "before": "time > 1"})").passed);
    CHECK_FALSE(judge_that(R"({"that": "time >= 1", "before": "time >= 1"})").passed);
}
