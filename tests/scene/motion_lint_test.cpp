// The warnings of bodies that may pass through others, for worlds with impacts at the end of the step: by default, fast
// bodies are swept against all others, and cause none.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "scene/warnings.hpp"

using namespace tumble;
using test::says;

namespace {

const std::vector<std::string> kAtStepEnd{"/world/impacts=at_step_end"};

std::vector<Diagnostic> at_step_end_warnings(const std::string& bodies, const std::string& rest = "") {
    return test::warnings_of(bodies, rest, kAtStepEnd);
}

Diagnostic at_step_end_warning(const std::string& bodies, const std::string& rest = "") {
    return test::warning_of(bodies, rest, kAtStepEnd);
}

}  // namespace

TEST_CASE("a body that moves farther in a step than it is thick causes a warning, unless it is swept") {
    // 60 m/s at 60 Hz: 1 m a step; the ball is 0.5 m thick.
    const std::string target = R"({"position": [50, 0], "shapes": [{"box": {"size": [1, 1]}}]}, )";
    const std::string ball = R"({"velocity": [60, 0], "shapes": [{"circle": {"radius": 0.25}}])";
    const Diagnostic fast = at_step_end_warning(target + ball + "}");
    CHECK(fast.pointer == "/bodies/1/velocity");
    CHECK(says(fast,
               "the body moves 1 m in a step, and the body is 0.5 m thick: it may pass through other moving bodies"));
    CHECK(at_step_end_warnings(target + ball + R"(, "bullet": true})").empty());
    CHECK(fast.hint.find(R"("impacts": "in_order")") != std::string::npos);
    CHECK(at_step_end_warnings(target + ball + "}", R"(, "world": {"steps_per_second": 240})").empty());
    const Diagnostic unswept =
        at_step_end_warning(target + ball + R"(, "bullet": true})", R"(, "world": {"continuous": false})");
    CHECK(says(unswept, "anything in its path, because the world is not continuous"));
    CHECK(unswept.hint.find(R"("continuous": true)") != std::string::npos);
    // With impacts in order, continuous collision sweeps the ball against all others.
    CHECK(test::warnings_of(target + ball + "}").empty());
    CHECK(says(test::warning_of(target + ball + "}", R"(, "world": {"continuous": false})"), "not continuous"));
    // No body is faster than 400 m/s: 6.67 m a step.
    CHECK(says(at_step_end_warning(target + R"({"velocity": [0, 90000], "shapes": [{"circle": {"radius": 0.25}}]})"),
               "moves 6.67 m in a step"));
}

TEST_CASE(
    "a body whose ends turn farther in a step than it is thick causes a warning, one that is round or does not turn "
    "causes none") {
    // 1200 degrees/s at 60 Hz: 0.349 rad; the ends are 2.0025 m from the centre of mass, the blade is 0.2 m thick.
    const auto blade = [](const std::string& more) {
        return R"({"position": [50, 0], "shapes": [{"circle": {"radius": 0.5}}]}, {"name": "blade", "shapes": [{"box": {"size": [4, 0.2], "center": [7, 0]}}])" +
               more + "}";
    };
    const std::string spin = R"(, "angular_velocity": -1200)",
                      later = R"(, "timeline": [{"at": 1, "body": "blade", "angular_velocity": 1200}])";
    const Diagnostic spinning = at_step_end_warning(blade(spin));
    CHECK(spinning.pointer == "/bodies/1/angular_velocity");
    CHECK(says(spinning, "moves the ends of the body by up to 0.699 m in a step, and the body is 0.2 m thick"));
    CHECK(at_step_end_warning(blade(""), later).pointer == "/timeline/0/angular_velocity");
    CHECK(at_step_end_warnings(blade(R"(, "angular_velocity": 300)")).empty());
    CHECK(at_step_end_warnings(blade(spin + R"(, "bullet": true)")).empty());
    CHECK(at_step_end_warnings(blade(spin + R"(, "fixed_rotation": true)")).empty());
    // No more than an eighth of a turn a step: 1.57 m, unless it may turn faster.
    CHECK(says(at_step_end_warning(blade(R"(, "angular_velocity": 90000)")), "by up to 1.57 m"));
    CHECK(says(at_step_end_warning(blade(R"(, "angular_velocity": 9000, "allow_fast_rotation": true)")),
               "by up to 5.24 m"));
    // A mass of its own far outside: the farthest corner is 9.0006 m from there.
    CHECK(says(at_step_end_warning(blade(spin + R"(, "mass": {"mass": 1, "center": [0, 0], "inertia": 1})")),
               "by up to 3.14 m"));
    const std::string wheel =
        R"({"position": [50, 0], "shapes": [{"circle": {"radius": 0.5}}]}, {"shapes": [{"circle": {"radius": 0.5, "center": [3, 0]}}], "allow_fast_rotation": true, "angular_velocity": 90000})";
    CHECK(at_step_end_warnings(wheel).empty());
}

TEST_CASE("an arm that a motor swings farther in a step than it is thick causes a warning at the fastest speed") {
    // 900 degrees/s of a tip 2 m away at 60 Hz: 15.7 x 2 / 60 = 0.524 m; the arm is 0.2 m thick.
    const std::string bodies =
        R"({"name": "wall", "type": "static", "position": [-1, 0]}, {"name": "ball", "position": [0, 5], "shapes": [{"circle": {"radius": 0.5}}]},
        {"name": "arm", "shapes": [{"box": {"size": [2, 0.2]}}])";
    const auto joint = [](const std::string& speed, const std::string& events) {
        return R"(, "joints": [{"type": "revolute", "name": "hinge", "bodies": ["wall", "arm"], "anchor": [-1, 0], "motor": {"speed": )" +
               speed + R"(, "max_torque": 100}}], "timeline": [)" + events + "]";
    };
    const Diagnostic fast = at_step_end_warning(bodies + "}", joint("900", ""));
    CHECK(fast.pointer == "/joints/0/motor");
    CHECK(says(fast, "the joint moves 'arm' by up to 0.524 m in a step, and the body is 0.2 m thick"));
    CHECK(
        at_step_end_warning(bodies + "}", joint("0", R"({"at": 1, "joint": "hinge", "motor_speed": -900})")).pointer ==
        "/timeline/0/motor_speed");
    CHECK(at_step_end_warning(bodies + "}", joint("900", R"({"at": 1, "joint": "hinge", "motor_speed": -800})"))
              .pointer == "/joints/0/motor");
    CHECK(at_step_end_warnings(bodies + R"(, "bullet": true})", joint("900", "")).empty());
    CHECK(says(
        at_step_end_warning(bodies + R"(, "bullet": true})", joint("900", "") + R"(, "world": {"continuous": false})"),
        "not continuous"));
    CHECK(at_step_end_warnings(bodies + "}", joint("300", "")).empty());
    CHECK(says(at_step_end_warning(bodies + "}", joint("0", R"({"at": 1, "body": "ball", "velocity": [90, 0]})")),
               "moves 1.5 m in a step"));
    // A motor joint drives by velocities of its own: 30 / 60 m, and 1800 degrees/s of the tip.
    const auto drive = [](const std::string& velocity) {
        return R"(, "joints": [{"type": "motor", "bodies": ["wall", "arm"], "anchor": [-1, 0], "max_force": 1, "max_torque": 1, )" +
               velocity + "}]";
    };
    CHECK(says(at_step_end_warning(bodies + "}", drive(R"("velocity": [18, 24])")),
               "the joint moves 'arm' by up to 0.5 m in a step"));
    const Diagnostic turned =
        at_step_end_warning(bodies + "}", drive(R"("velocity": [0, 9], "angular_velocity": 1800)"));
    CHECK(turned.pointer == "/joints/0/angular_velocity");
    CHECK(says(turned, "the joint moves 'arm' by up to 1.05 m in a step"));
}
