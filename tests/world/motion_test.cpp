// Bodies without contact, against the closed forms of their motion and of the integration scheme.
#include <doctest/doctest.h>

#include <cmath>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr int kSubsteps = 4;
constexpr double kH = 1.0 / 240.0;
constexpr double kGravity = 10.0;

// Velocities accumulate in float: each of n sums is rounded by at most half an ulp of the largest.
double rounding(int sums, double largest) { return sums * 0x1p-24 * largest; }

}  // namespace

TEST_CASE("a body in free fall follows its parabola") {
    World world;
    const BodyId ball = add_dynamic(world, {3.0, 100.0}, make_circle(0.5f));
    for (int step = 1; step <= 120; ++step) {
        world.step();
        const double t = step / 60.0, v = -kGravity * t;
        const BodyState state = world.state(ball);
        CHECK(std::abs(state.velocity.y - v) <= rounding(2, std::abs(v)));
        CHECK(std::abs(state.pose.position.y - (100.0 + 0.5 * v * t)) <= rounding(step, std::abs(v) / 60.0));
        CHECK(state.pose.position.x == 3.0);
        CHECK(state.pose.rotation == Rotation{});
    }
}

TEST_CASE("a projectile lands where its parabola ends") {
    World world;
    const BodyId ball = add_dynamic(world, {}, make_circle(0.1f));
    world.set_velocity(ball, {8.0f, 6.0f}, 0.0f);
    run(world, 72);  // 1.2 s: back at its initial height
    const BodyState state = world.state(ball);
    CHECK(std::abs(state.pose.position.x - 8.0 * 1.2) <= rounding(72, 8.0 / 60.0));
    CHECK(std::abs(state.pose.position.y) <= rounding(72, 6.0 / 60.0));
}

// A body with a joint moves as the solver has it: v_n = -g h n and y_n = h sum of v_k = -g h^2 n (n + 1) / 2. A motor
// without torque does nothing else.
TEST_CASE("a joined body in free fall follows the sum of the semi-implicit scheme") {
    for (const ImpactModel impacts : {ImpactModel::in_order, ImpactModel::at_step_end}) {
        World world({.impacts = impacts});
        const BodyId ball = add_dynamic(world, {3.0, 100.0}, make_circle(0.5f));
        const BodyId pin = world.create_body({.type = BodyType::static_body});
        world.create_joint(MotorJointDef{.body_a = pin, .body_b = ball});
        for (int step = 1; step <= 120; ++step) {
            world.step();
            const int n = step * kSubsteps;
            const double v = -kGravity * kH * n;
            const double y = 100.0 - kGravity * kH * kH * n * (n + 1) / 2.0;
            const BodyState state = world.state(ball);
            CHECK(std::abs(state.velocity.y - v) <= rounding(n, std::abs(v)));
            CHECK(std::abs(state.pose.position.y - y) <= rounding(n, std::abs(v)) * n * kH + rounding(n, 1.0));
        }
    }
}

TEST_CASE("far from the origin a body falls as it does at the origin") {
    World home, away;
    const DVec2 far{16.0e6, -3.0e6};
    const BodyId near_ball = add_dynamic(home, {0.0, 8.0}, make_circle(0.5f));
    const BodyId far_ball = add_dynamic(away, far + DVec2{0.0, 8.0}, make_circle(0.5f));
    run(home, 100);
    run(away, 100);
    // Positions are double: at 16 000 km one ulp is 4 nm, and every step rounds once.
    const DVec2 difference = away.state(far_ball).pose.position - far - home.state(near_ball).pose.position;
    CHECK(length(difference) < 100 * 4e-9);
    CHECK(away.state(far_ball).velocity == home.state(near_ball).velocity);
}

TEST_CASE("a free body keeps its angular velocity bit for bit, and rotates by it") {
    World world = weightless();
    const BodyId box = add_dynamic(world, {}, make_box({1.0f, 2.0f}));
    world.set_velocity(box, {1.0f, 0.0f}, 2.0f);
    run(world, 60);
    CHECK(world.state(box).angular_velocity == 2.0f);
    CHECK(world.state(box).velocity == Vec2{1.0f, 0.0f});
    // 240 sub-steps of 1/120 rad, each wrong by angle^5 / 120 = 3e-13, and 60 roundings of the rotation by 6e-8.
    CHECK(std::abs(angle(world.state(box).pose.rotation) - 2.0) < 60 * 1.2e-7);
}

TEST_CASE("a body whose shape is off its origin rotates about its centre of mass") {
    World world = weightless();
    BodyDef def;
    def.pose = {{5.0, 5.0}, make_rotation_degrees(90.0)};
    const BodyId body = world.create_body(def);
    world.add_shape(body, {make_box({1.0f, 1.0f}, 0.0f, {2.0f, 0.0f}), {}});
    CHECK(near(world.mass(body).center.x, 2.0, kFloat));
    world.set_velocity(body, {0.0f, 0.0f}, 1.0f);
    run(world, 90);
    // The centre of mass stays at the origin plus the offset turned by 90 degrees: (5, 7).
    const BodyState state = world.state(body);
    const DVec2 center = transform_point(state.pose, world.mass(body).center);
    CHECK(length(center - DVec2{5.0, 7.0}) < 1e-5);
    CHECK(near(length(state.pose.position - center), 2.0, kFloat));
}

TEST_CASE("adding a shape keeps the velocity of every point of the body") {
    World world = weightless();
    BodyDef def;
    def.velocity = {1.0f, 0.0f};
    def.angular_velocity = 3.0f;
    const BodyId body = world.create_body(def);
    world.add_shape(body, {make_box({1.0f, 1.0f}), {}});
    world.add_shape(body, {make_box({1.0f, 1.0f}, 0.0f, {4.0f, 0.0f}), {}});
    // The centre of mass has moved to (2, 0), where the body moves by (1, 0) + 3 x (2, 0) = (1, 6).
    CHECK(near(world.state(body).velocity.x, 1.0, kFloat));
    CHECK(near(world.state(body).velocity.y, 6.0, kFloat));
}

TEST_CASE("mass, centre and inertia of a body are the sums over its shapes") {
    World world;
    const BodyId body = world.create_body({});
    world.add_shape(body, {make_box({2.0f, 2.0f}, 0.0f, {-1.0f, 0.0f}), {.density = 3.0f}});
    world.add_shape(body, {make_box({2.0f, 2.0f}, 0.0f, {1.0f, 0.0f}), {.density = 1.0f}});
    // Masses 12 and 4 at -1 and 1: centre -0.5; inertia 12 * 4 (8/12 each m a^2/6) about own centres plus parallel
    // axes: 12 * (4/6 + 0.25) + 4 * (4/6 + 2.25) = 11 + 11.6667.
    const BodyMass mass = world.mass(body);
    CHECK(near(mass.mass, 16.0, kFloat));
    CHECK(near(mass.center.x, -0.5, kFloat));
    CHECK(near(mass.inertia, 11.0 + 35.0 / 3.0, kFloat));
}

TEST_CASE("damping is exponential") {
    World world = weightless();
    BodyDef def;
    def.velocity = {10.0f, 0.0f};
    def.angular_velocity = 4.0f;
    def.linear_damping = 0.5f;
    def.angular_damping = 2.0f;
    const BodyId body = world.create_body(def);
    world.add_shape(body, {make_circle(0.5f), {}});
    run(world, 60);
    CHECK(near(world.state(body).velocity.x, 10.0 * std::exp(-0.5), relative(60 * 0x1p-24)));
    CHECK(near(world.state(body).angular_velocity, 4.0 * std::exp(-2.0), relative(60 * 0x1p-24)));
    CHECK(near(world.state(body).pose.position.x, 10.0 / 0.5 * (1.0 - std::exp(-0.5)), relative(60 * 0x1p-24)));
}

TEST_CASE("with impacts at the step's end damping divides by 1 + h c in every sub-step") {
    World world({.gravity = {}, .impacts = ImpactModel::at_step_end});
    const BodyId body = add_dynamic(world, {}, make_circle(0.5f));
    world.set_damping(body, 0.5f, 2.0f);
    world.set_velocity(body, {10.0f, 0.0f}, 4.0f);
    run(world, 60);
    // The factor is rounded by 3 / 2^24 at most (h, the sum, the quotient), 240 times over.
    const double tolerance = 240 * 3 * 0x1p-24;
    CHECK(near(world.state(body).velocity.x, 10.0 / std::pow(1.0 + 0.5 * kH, 240), relative(tolerance)));
    CHECK(near(world.state(body).angular_velocity, 4.0 / std::pow(1.0 + 2.0 * kH, 240), relative(tolerance)));
}

TEST_CASE("gravity scale multiplies gravity") {
    World world;
    BodyDef def;
    def.gravity_scale = -0.5f;
    const BodyId balloon = world.create_body(def);
    world.add_shape(balloon, {make_circle(0.5f), {}});
    run(world, 60);
    CHECK(near(world.state(balloon).velocity.y, 5.0, float_sum(240)));
}

TEST_CASE("a kinematic body moves by its velocity alone") {
    World world;
    const BodyId lift = add_body(world, BodyType::kinematic_body, {}, make_box({4.0f, 1.0f}));
    world.set_velocity(lift, {0.0f, 2.0f}, 0.0f);
    const BodyId crate = add_dynamic(world, {0.0, 1.0}, make_box({1.0f, 1.0f}));
    run(world, 120);
    CHECK(world.state(lift).velocity == Vec2{0.0f, 2.0f});
    CHECK(near(world.state(lift).pose.position.y, 4.0, kFloat));
    // The crate is carried; it sinks into the lift by 1.25 g / (4 w^2), below a tenth of a millimetre.
    CHECK(near(world.state(crate).pose.position.y, 5.0, absolute(kRestingDepth)));
}

TEST_CASE("speed and rotation are limited, rotation not with allow_fast_rotation") {
    World world = weightless();
    const BodyId fast = add_dynamic(world, {}, make_circle(0.5f));
    world.set_velocity(fast, {3000.0f, 4000.0f}, 1000.0f);
    BodyDef def;
    def.allow_fast_rotation = true;
    def.angular_velocity = 200.0f;
    const BodyId wheel = world.create_body(def);
    world.step();
    CHECK(near(length(world.state(fast).velocity), 400.0, kFloat));
    CHECK(near(world.state(fast).velocity.y / world.state(fast).velocity.x, 4.0 / 3.0, kFloat));
    CHECK(near(world.state(fast).angular_velocity, 0.25 * kPi * 60.0, kFloat));
    CHECK(world.state(wheel).angular_velocity == 200.0f);
}
