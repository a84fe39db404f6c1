// The work of motors, which a claim on energy does not count as gain.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "support/near.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

struct Judged {
    bool passed = false;
    std::string finding;
    double work = 0.0;  // J
    BodyState body;     // the first of the scene, at the end
};

Judged judge(const std::string& members, double gain, double seconds) {
    const Scene scene = parse_scene(R"({"format": 1, "materials": {"m": {"density": 4, "friction": 0.5}}, )" + members +
                                        R"(, "expect": [{"max_energy_gain": )" + std::to_string(gain) + "}]}",
                                    "");
    SceneRun run(scene);
    ExpectationWatch watch(scene, run.built());
    watch.observe(run.built());
    for (std::uint64_t step = nearest_step(seconds, scene.world.steps_per_second); step > 0; --step) {
        run.step();
        watch.observe(run.built());
    }
    const ExpectationResult result = watch.results()[0];
    return {result.passed, result.finding, run.built().work, run.world().state(run.built().bodies[0].id)};
}

// A body of 1 kg on an upward rail with a motor of 0.5 m/s.
std::string lift(const std::string& force, const std::string& more = "") {
    return R"("bodies": [{"name": "weight", "shapes": [{"box": {"size": [0.5, 0.5]}, "material": "m"}]},
                         {"name": "frame", "type": "static"})" +
           more + R"(], "joints": [{"type": "prismatic", "bodies": ["frame", "weight"], "anchor": [0, 0],
            "axis": [0, 1], "motor": {"speed": 0.5, "max_force": )" +
           force + "}}]";
}

}  // namespace

TEST_CASE("a motor that lifts a weight does the work that the weight gains") {
    // From rest: m g h + m v^2 / 2 with g = 10 m/s^2 and v = 0.5 m/s.
    for (const char* force : {"12", "20", "1e6"}) {
        CAPTURE(force);
        const Judged lifted = judge(lift(force), 1e-4, 2.0);
        CHECK_MESSAGE(lifted.passed, lifted.finding);
        const double height = lifted.body.pose.position.y;
        CHECK(height > 0.85);
        CHECK(near(lifted.work, 10.0 * height + 0.125, relative(1e-4)));
    }
}

TEST_CASE("a motor that drags a crate does the work of friction, and the energy stays") {
    // mu m g per metre at a steady speed. The motor pushes the crate along the floor. Its force in the last
    // sub-step of a step differs from the mean by a few per cent.
    const std::string drag = R"("bodies": [
        {"name": "crate", "position": [0, 0.25], "velocity": [0.5, 0],
         "shapes": [{"box": {"size": [1, 0.5]}, "material": "m"}]},
        {"name": "floor", "type": "static", "position": [0, -0.5],
         "shapes": [{"box": {"size": [20, 1]}, "material": "m"}]}, {"name": "frame", "type": "static"}],
        "joints": [{"type": "distance", "bodies": ["frame", "crate"], "anchors": [[-5, 0.25], [0, 0.25]],
                    "limits": [0, 20], "motor": {"speed": 0.5, "max_force": 100}}])";
    const Judged early = judge(drag, 1e-3, 1.0), late = judge(drag, 1e-3, 3.0);
    CHECK_MESSAGE(late.passed, late.finding);
    const double metres = late.body.pose.position.x - early.body.pose.position.x;
    CHECK(near(metres, 1.0, relative(0.01)));
    CHECK(near(late.work - early.work, 0.5 * 2.0 * 10.0 * metres, relative(0.03)));
}

TEST_CASE("a motor that starts, stops and hits something within steps holds the claim") {
    const std::string paddle = R"("world": {"gravity": [0, 0]}, "bodies": [
        {"name": "ball", "position": [0, 1], "shapes": [{"circle": {"radius": 0.2}}]},
        {"name": "paddle", "shapes": [{"box": {"size": [3, 0.2]}}]}, {"name": "frame", "type": "static"}],
        "joints": [{"type": "revolute", "name": "hinge", "bodies": ["frame", "paddle"], "anchor": [0, 0],
                    "motor": {"speed": 300, "max_torque": 1000}}],
        "timeline": [{"at": 1, "joint": "hinge", "motor_speed": -200}])";
    const Judged hit = judge(paddle, 0.01, 2.0);
    CHECK_MESSAGE(hit.passed, hit.finding);
    CHECK(hit.work > 1.0);
    CHECK(length(hit.body.velocity) > 1.0f);
}

// An arm sleeps on a hinge at its centre, held by a brake of 30 N m. A ball falls on its end: the brake slips, and
// takes 30 J for each radian.
TEST_CASE("the work of a motor is counted from the step in which a hit wakes its joint") {
    const Scene scene = parse_scene(R"({"format": 1, "bodies": [
        {"name": "arm", "shapes": [{"box": {"size": [4, 0.2]}}]}, {"name": "frame", "type": "static"},
        {"name": "ball", "position": [1.8, 12], "shapes": [{"circle": {"radius": 0.5}}]}],
        "joints": [{"type": "revolute", "bodies": ["frame", "arm"], "anchor": [0, 0],
                    "motor": {"speed": 0, "max_torque": 30}}]})",
                                    "");
    SceneRun run(scene);
    const BodyId arm = run.built().bodies[0].id;
    double asleep_until = 0.0;
    for (int step = 0; step < 150; ++step) {
        if (!run.world().is_awake(arm)) asleep_until = run.time();
        run.step();
    }
    CHECK(asleep_until > 1.0);
    const double turned = std::abs(angle(run.world().state(arm).pose.rotation));
    CHECK(turned > 0.5);
    CHECK(near(run.built().work, -30.0 * turned, relative(0.02)));
}

TEST_CASE("the work of a motor that a program puts to sleep is counted from the pose in which it slept") {
    const Scene scene = parse_scene(R"({"format": 1, "bodies": [
        {"name": "arm", "shapes": [{"box": {"size": [4, 0.2]}}], "angular_velocity": 180},
        {"name": "frame", "type": "static"},
        {"name": "ball", "position": [1.8, 12], "shapes": [{"circle": {"radius": 0.5}}]}],
        "joints": [{"type": "revolute", "bodies": ["frame", "arm"], "anchor": [0, 0],
                    "motor": {"speed": 180, "max_torque": 30}}]})",
                                    "");
    SceneRun run(scene);
    const BodyId arm = run.built().bodies[0].id;
    const JointId joint = run.built().joints[0].id;
    for (int step = 0; step < 10; ++step) run.step();
    CHECK(near(run.built().work, 0.0, absolute(1e-3)));  // the motor keeps the speed
    auto hinge = std::get<RevoluteJointDef>(run.world().joint(joint));
    hinge.motor->speed = 0.0f;
    run.world().set_joint(joint, hinge);
    run.world().set_awake(arm, false);
    const double slept_at = angle(run.world().state(arm).pose.rotation);
    CHECK(slept_at > 0.5);
    for (int step = 0; step < 140; ++step) run.step();
    const double turned = std::abs(angle(run.world().state(arm).pose.rotation) - slept_at);
    CHECK(turned > 0.3);
    CHECK(near(run.built().work, -30.0 * turned, relative(0.02)));
}

TEST_CASE("what a motor cannot have done is a gain") {
    // A kinematic plate lifts the weight of 10 N by 2 m, and the motor has 1 N: at least 9 N x 2 m are a gain.
    const std::string plate = R"(, {"name": "plate", "type": "kinematic", "position": [0, -0.5], "velocity": [0, 1],
                                     "shapes": [{"box": {"size": [4, 0.5]}}]})";
    const Judged lifted = judge(lift("1", plate), 17.0, 2.0);
    CHECK(near(lifted.body.pose.position.y, 2.0, relative(0.02)));
    CHECK_FALSE(lifted.passed);
    CHECK(lifted.finding.ends_with(" J above that of the start and the work of events and motors"));
    CHECK(lifted.work < 2.1);
}

TEST_CASE("the work of motors is left out, and counted again, when a program asks for it") {
    // The second weight loses its motor at 0.5 s.
    const Scene scene = parse_scene(R"({"format": 1, "world": {"gravity": [0, -10]}, "bodies": [
        {"name": "weight", "repeat": {"grid": {"columns": 2, "spacing": [2, 0]}}, "shapes": [{"box": {"size": [0.5, 0.5]}}]},
        {"name": "frame", "type": "static"}],
        "joints": [{"name": "lift", "type": "prismatic", "bodies": ["frame", "weight[0]"], "anchor": [0, 0],
                    "axis": [0, 1], "motor": {"speed": 0.5, "max_force": 100}},
                   {"name": "other", "type": "prismatic", "bodies": ["frame", "weight[1]"], "anchor": [2, 0],
                    "axis": [0, 1], "motor": {"speed": 0.5, "max_force": 100}}],
        "timeline": [{"at": 0.5, "release": "other"}]})",
                                    "");
    SceneRun always(scene), later(scene);
    later.count_motor_work(false);
    const auto step_both = [&](int steps) {
        for (int i = 0; i < steps; ++i) always.step(), later.step();
    };
    step_both(60);
    CHECK(later.built().work == 0.0);
    CHECK(always.built().work > 1.0);
    later.count_motor_work(true);
    const double before = always.built().work;
    step_both(30);
    CHECK(always.built().work - before > 0.5);
    CHECK(near(later.built().work, always.built().work - before, relative(1e-9)));
    CHECK(later.world().state_hash() == always.world().state_hash());
}
