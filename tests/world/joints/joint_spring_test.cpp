// The springs of joints: frequency, damping, equilibrium and stability.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "support/joint_rig.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kGravity = 10.0;
constexpr double kH = 1.0 / 240.0;

// Of a period. Between two samples of a sine that are d apart in phase, a zero is interpolated to 0.1 d^2 / 6 of a
// step: at 3 Hz, d = 0.31, to 0.0016 steps at either end of 100.
constexpr double kInterpolation = 5e-5;

// Mean time between upward passages of a value through 0, and the ratio of successive maxima.
struct Oscillation {
    double period = 0.0;
    double decay = 0.0;
};

template <class Value>
Oscillation measure(World& world, int steps, Value&& value) {
    double before = value(), first = -1.0, last = -1.0;
    int passages = -1;
    std::vector<double> maxima;
    double older = -1e9;
    for (int step = 1; step <= steps; ++step) {
        world.step();
        const double now = value();
        if (before <= 0.0 && now > 0.0) {
            last = (step - now / (now - before)) / 60.0;
            if (++passages == 0) first = last;
        }
        if (before > older && before >= now && before > 0.0) maxima.push_back(before);
        older = before;
        before = now;
    }
    REQUIRE(passages > 0);
    REQUIRE(maxima.size() > 1);
    const double ratio = std::pow(maxima.back() / maxima.front(), 1.0 / static_cast<double>(maxima.size() - 1));
    return {(last - first) / passages, ratio};
}

// The frequency and damping of the implicit spring of frequency f and damping ratio z with sub-step h, for mass 1 and
// an exact solve of v' = v - h w^2 (x + h v') - 2 z w h v', x' = x + h v': the eigenvalues of the step have modulus 1 /
// sqrt(D) and cosine (1 + 1 / D - h^2 w^2 / D) sqrt(D) / 2 with D = 1 + 2 z w h + h^2 w^2.
Oscillation implicit_spring(double f, double z) {
    const double w = 2.0 * kPi * f;
    const double d = 1.0 + 2.0 * z * w * kH + kH * kH * w * w;
    const double trace = 1.0 + (1.0 - kH * kH * w * w) / d;  // of [[1 - h^2 w^2 / D, h / D], [-h w^2 / D, 1 / D]]
    const double angle = std::acos(trace / 2.0 * std::sqrt(d));
    const double period = 2.0 * kPi * kH / angle;
    return {period, std::pow(1.0 / d, 0.5 * period / kH)};
}

}  // namespace

TEST_CASE("the angular spring of a hinge has the frequency and damping of its definition") {
    Rig rig(false);
    rig.world.create_joint(
        RevoluteJointDef{.body_a = rig.pivot, .body_b = rig.box, .spring = JointSpring{2.0f, 0.02f}});
    rig.world.set_velocity(rig.box, {}, 2.0f);
    const Oscillation seen = measure(rig.world, 300, [&] { return rig.angle(); });
    const Oscillation expected = implicit_spring(2.0, 0.02);
    // Implicit steps lengthen the period by (w h)^2 / 3 + z w h = 0.2 % to first order.
    CHECK(near(expected.period, 0.5, relative(0.003)));
    // Samples of a sine at 30 a period: a maximum between two is up to (pi / 30)^2 / 2 = 0.55 % higher, and the decay
    // is the eighth root of the ratio of two.
    CHECK(near(seen.period, expected.period, relative(kInterpolation)));
    CHECK(near(seen.decay, expected.decay, relative(0.0055 / 8.0)));
}

TEST_CASE("a weight extends a spring by m g / (m w^2), and oscillates at its frequency") {
    Rig rig(true, {0.0, -2.0});
    rig.world.create_joint(
        DistanceJointDef{.body_a = rig.pivot, .body_b = rig.box, .length = 2.0f, .spring = JointSpring{1.0f, 0.1f}});
    const double sag = kGravity / (4.0 * kPi * kPi);
    const Oscillation seen = measure(rig.world, 240, [&] { return rig.position().y + 2.0 + sag; });
    const Oscillation expected = implicit_spring(1.0, 0.1);
    CHECK(near(seen.period, expected.period, relative(kInterpolation)));
    CHECK(near(seen.decay, expected.decay, relative(0.0014 / 3.0)));  // (pi / 60)^2 / 2, in 4 maxima
    rig.world.set_allow_sleep(rig.box, false);
    run(rig.world, 1440);
    CHECK(near(-rig.position().y - 2.0, sag, absolute(1e-6)));
}

// Other joints of two boards increase their effective mass beyond the one that a spring between them assumes.
TEST_CASE("boards with springs of any stiffness between them, also at a wall, never gain more than 1 % of energy") {
    for (const float hertz : {30.0f, 60.0f, 240.0f})
        for (const float damping : {0.0f, 1.0f})
            for (const bool at_wall : {false, true}) {
                CAPTURE(hertz);
                CAPTURE(damping);
                CAPTURE(at_wall);
                World world = weightless();
                BodyId before = world.create_body({.type = BodyType::static_body});
                std::vector<BodyId> boards;
                for (int i = 0; i < 6; ++i) {
                    const BodyId board = add_dynamic(world, {i + 0.5, 0.0}, make_box({1.0f, 0.1f}));
                    const Vec2 end{i == 0 ? 0.0f : 0.5f, 0.0f};
                    if (i > 0 || at_wall)
                        world.create_joint(WeldJointDef{.body_a = before,
                                                        .body_b = board,
                                                        .anchor_a = end,
                                                        .anchor_b = {-0.5f, 0.0f},
                                                        .angular_spring = JointSpring{hertz, damping}});
                    boards.push_back(before = board);
                }
                world.set_velocity(boards.back(), {}, 1.0f);
                const auto kinetic = [&] {
                    double sum = 0.0;
                    for (const BodyId board : boards) {
                        const BodyState state = world.state(board);
                        const BodyMass mass = world.mass(board);
                        const double w = static_cast<double>(state.angular_velocity);
                        sum += 0.5 * double{mass.mass} * length_sq(DVec2(state.velocity)) +
                               0.5 * double{mass.inertia} * w * w;
                    }
                    return sum;
                };
                const double start = kinetic();
                for (int step = 0; step < 600; ++step) {
                    world.step();
                    REQUIRE(kinetic() < 1.01 * start);
                }
            }
}

TEST_CASE("a slider with a spring swings at its frequency") {
    Rig rig(false);
    rig.world.create_joint(
        PrismaticJointDef{.body_a = rig.pivot, .body_b = rig.box, .spring = JointSpring{3.0f, 0.0f}});
    rig.world.set_velocity(rig.box, {1.0f, 0.0f}, 0.0f);
    const Oscillation seen = measure(rig.world, 120, [&] { return rig.position().x; });
    CHECK(near(seen.period, implicit_spring(3.0, 0.0).period, relative(kInterpolation)));
}

TEST_CASE("a weld with an angular spring swings at its frequency") {
    Rig rig(false);
    rig.world.create_joint(
        WeldJointDef{.body_a = rig.pivot, .body_b = rig.box, .angular_spring = JointSpring{2.0f, 0.0f}});
    rig.world.set_velocity(rig.box, {}, 1.0f);
    const Oscillation seen = measure(rig.world, 240, [&] { return rig.angle(); });
    CHECK(near(seen.period, implicit_spring(2.0, 0.0).period, relative(kInterpolation)));
}

TEST_CASE("a weld with a linear spring hangs as far down as g / w^2") {
    Rig rig(true);
    rig.world.create_joint(
        WeldJointDef{.body_a = rig.pivot, .body_b = rig.box, .linear_spring = JointSpring{2.0f, 0.5f}});
    rig.world.set_allow_sleep(rig.box, false);
    run(rig.world, 600);
    CHECK(near(rig.position().y, -kGravity / (16.0 * kPi * kPi), absolute(1e-6)));
}

TEST_CASE("a motor joint with a spring swings at its frequency, along and about") {
    Rig rig(false);
    rig.world.create_joint(MotorJointDef{.body_a = rig.pivot,
                                         .body_b = rig.box,
                                         .max_force = 1e6f,
                                         .max_torque = 1e6f,
                                         .spring = JointSpring{2.0f, 0.0f}});
    rig.world.set_velocity(rig.box, {}, 1.0f);
    CHECK(near(measure(rig.world, 240, [&] { return rig.angle(); }).period, implicit_spring(2.0, 0.0).period,
               relative(kInterpolation)));
    rig.world.set_transform(rig.box, {});
    rig.world.set_velocity(rig.box, {1.0f, 0.0f}, 0.0f);
    CHECK(near(measure(rig.world, 240, [&] { return rig.position().x; }).period, implicit_spring(2.0, 0.0).period,
               relative(kInterpolation)));
}
