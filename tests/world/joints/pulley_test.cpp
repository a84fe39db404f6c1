// Pulley joints against Atwood's machine and the block and tackle.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kGravity = 10.0;
constexpr double kJointOmega = 2.0 * kPi * 60.0;  // joint softness, rad/s
constexpr double kRopeRounding = 0x1p-20;         // m: the ulp of lengths of 8 to 16 m as floats

// Two boxes under wheels at (-2, 10) and (2, 10), on 5 m of rope each.
struct Atwood {
    World world{WorldDef{.sleeping = false}};
    BodyId a, b;
    JointId pulley;
    PulleyJointDef def;

    Atwood(float mass_a, float mass_b, float ratio) {
        a = add_dynamic(world, {-2.0, 5.0}, make_box({1.0f, 1.0f}), {.density = mass_a});
        b = add_dynamic(world, {2.0, 5.0}, make_box({1.0f, 1.0f}), {.density = mass_b});
        def = {.body_a = a,
               .body_b = b,
               .ground_anchor_a = {-2.0, 10.0},
               .ground_anchor_b = {2.0, 10.0},
               .length = 5.0f + 5.0f * ratio,
               .ratio = ratio};
        pulley = world.create_joint(def);
    }

    DVec2 place(BodyId body) const { return world.state(body).pose.position; }
    double rope() const {
        return length(place(a) - def.ground_anchor_a) + double{def.ratio} * length(place(b) - def.ground_anchor_b);
    }
    double energy() const {
        double sum = 0.0;
        for (const BodyId id : {a, b})
            sum += double{world.mass(id).mass} *
                   (kGravity * place(id).y + 0.5 * length_sq(DVec2(world.state(id).velocity)));
        return sum;
    }
};

}  // namespace

// The rope pulls A with T and B with r T, and v_A = -r v_B: B falls with a = g (m_B - r m_A) / (m_B + r^2 m_A), and
// T = m_A m_B g (1 + r) / (m_B + r^2 m_A). The rope yields by T K / w^2, K = 1 / m_A + r^2 / m_B. Velocities are
// exact but for roundings, some 10 of 2^-24 in each of 240 sub-steps.
TEST_CASE("two weights on a pulley accelerate as Atwood's machine does, and as a block and tackle") {
    constexpr double kRounding = 240 * 10 * 0x1p-24;
    for (const float ratio : {1.0f, 2.0f, 0.5f}) {
        for (const float mass_b : {1.0f, 3.0f, 8.0f}) {
            CAPTURE(ratio);
            CAPTURE(mass_b);
            Atwood machine(2.0f, mass_b, ratio);
            run(machine.world, 60);
            const double r = ratio, m = mass_b, inverse = 1.0 / (m + 2.0 * r * r);
            const double falls = kGravity * (m - 2.0 * r) * inverse, tension = 2.0 * m * kGravity * (1.0 + r) * inverse;
            CHECK(std::abs(machine.world.state(machine.b).velocity.y + falls) < kRounding * kGravity);
            CHECK(std::abs(machine.world.state(machine.a).velocity.y - r * falls) < kRounding * kGravity * r);
            const Vec2 force = machine.world.reaction(machine.pulley).force;
            CHECK(near(force.y, r * tension, relative(kRounding)));
            CHECK(force.x == 0.0f);
            const double gives = tension * (0.5 + r * r / m) / (kJointOmega * kJointOmega);
            CHECK(near(machine.rope() - double{machine.def.length}, gives, absolute(kRopeRounding)));
        }
    }
}

TEST_CASE("half the weight balances a block and tackle of ratio 2") {
    Atwood machine(2.0f, 4.0f, 2.0f);
    run(machine.world, 300);
    CHECK(std::abs(machine.place(machine.a).y - 5.0) < 0.002);
    CHECK(std::abs(machine.place(machine.b).y - 5.0) < 0.002);
}

TEST_CASE("a rope has its length, and its position is the distance of A from its wheel") {
    Atwood machine(2.0f, 2.0f, 1.0f);
    machine.def.length = 8.0f;
    machine.world.set_joint(machine.pulley, machine.def);
    run(machine.world, 120);
    const double gives = 20.0 * (0.5 + 0.5) / (kJointOmega * kJointOmega);
    CHECK(near(machine.rope(), 8.0 + gives, absolute(kRopeRounding)));
    machine.world.step();
    CHECK(near(machine.world.joint_position(machine.pulley), 4.0 + 0.5 * gives, absolute(kRopeRounding)));
    const auto ends = machine.world.joint_anchors(machine.pulley);
    REQUIRE(ends);
    CHECK(ends->b == machine.place(machine.b));
}

// As in Box2D: under a rope that only pulls, A, which is pushed up, would let B fall freely.
TEST_CASE("the rope pushes where a real one would be slack") {
    Atwood machine(2.0f, 2.0f, 1.0f);
    machine.world.set_velocity(machine.a, {0.0f, 4.0f}, 0.0f);
    run(machine.world, 30);
    CHECK(near(machine.world.state(machine.a).velocity.y, 2.0, float_sum(120 * 10)));
    CHECK(near(machine.world.state(machine.b).velocity.y, -2.0, float_sum(120 * 10)));
}

// Of the swinging Atwood machine, for which no closed form is known.
TEST_CASE("weights that swing on a pulley gain at most 1 % of energy in a minute") {
    Atwood machine(2.0f, 3.0f, 1.0f);
    machine.world.set_velocity(machine.a, {5.0f, 0.0f}, 0.0f);
    // Lowest with the heavier one on all of the rope, 10 m below its wheel, and the other one at its own.
    const double start = machine.energy() - kGravity * 2.0 * 10.0;
    double gain = 0.0;
    for (int step = 0; step < 3600; ++step) {
        machine.world.step();
        gain = std::max(gain, machine.energy() - kGravity * 2.0 * 10.0 - start);
    }
    CHECK(near(start, kGravity * 3.0 * 5.0 - kGravity * 2.0 * 5.0 + 25.0, kDouble));
    CHECK(gain < 0.01 * start);
}

TEST_CASE("a rope that pulls at a corner rotates the body") {
    World world = weightless();
    const BodyId box = add_dynamic(world, {0.0, 0.0}, make_box({2.0f, 1.0f}));
    const BodyId weight = add_dynamic(world, {5.0, 0.0}, make_box({1.0f, 1.0f}));
    world.create_joint(PulleyJointDef{.body_a = box,
                                      .body_b = weight,
                                      .anchor_a = {1.0f, 0.0f},
                                      .ground_anchor_a = {1.0, 100.0},
                                      .ground_anchor_b = {5.0, 100.0},
                                      .length = 200.0f});
    world.set_velocity(weight, {0.0f, -1.0f}, 0.0f);
    world.step();
    // P on the weight of 1 kg, and on the box of 2 kg and I = 2 (4 + 1) / 12 with an arm of 1 m:
    // (-1 + P) + P / 2 + P / I = 0, where the corner rises. The box turns by 0.0074 rad in the step, which shortens its
    // arm by 2.7e-5.
    const double inverse_inertia = 12.0 / (2.0 * 5.0);
    const double impulse = 1.0 / (1.0 + 0.5 + inverse_inertia);
    CHECK(near(world.state(weight).velocity.y, impulse - 1.0, relative(2.7e-5)));
    CHECK(near(world.state(box).velocity.y, 0.5 * impulse, relative(2.7e-5)));
    CHECK(near(world.state(box).angular_velocity, inverse_inertia * impulse, relative(2.7e-5)));
}

TEST_CASE("a static body on one end carries the body on the other") {
    for (const bool locked : {false, true}) {
        Atwood machine(2.0f, 3.0f, 1.0f);
        if (locked)
            machine.world.set_locks(machine.a, {false, true, false});
        else
            machine.world.set_type(machine.a, BodyType::static_body);
        run(machine.world, 120);
        CHECK(near(machine.place(machine.a).y, 5.0, kFloat));
        // 30 N on 3 kg: g / w^2.
        CHECK(near(machine.place(machine.b).y, 5.0 - kGravity / (kJointOmega * kJointOmega), kFloat));
    }
}

TEST_CASE("a rope breaks above its force on B, and not below") {
    for (const float strength : {39.0f, 41.0f}) {  // two strands carry 40 N
        Atwood machine(2.0f, 4.0f, 2.0f);
        machine.def.break_force = strength;
        machine.world.set_joint(machine.pulley, machine.def);
        run(machine.world, 30);
        CHECK(machine.world.is_valid(machine.pulley) == (strength > 40.0f));
        machine.world.audit();
    }
}

TEST_CASE("bodies on one rope fall asleep and wake as one") {
    World world;
    const BodyId a = add_dynamic(world, {-2.0, 5.0}, make_box({1.0f, 1.0f}));
    const BodyId b = add_dynamic(world, {2.0, 5.0}, make_box({1.0f, 1.0f}));
    world.create_joint(PulleyJointDef{
        .body_a = a, .body_b = b, .ground_anchor_a = {-2.0, 10.0}, .ground_anchor_b = {2.0, 10.0}, .length = 10.0f});
    CHECK(world.islands() == std::vector<int>{0, 0});
    run(world, 120);
    REQUIRE(!world.is_awake(a));
    REQUIRE(!world.is_awake(b));
    world.apply_impulse(b, {0.0f, -1.0f}, world.state(b).pose.position);
    CHECK(world.is_awake(a));
    run(world, 10);
    CHECK(near(world.state(a).velocity.y, 0.5, kFloat));
    world.audit();
}

TEST_CASE("a body that is pulled up to its wheel stays finite") {
    Atwood machine(1.0f, 4.0f, 1.0f);
    for (int step = 0; step < 600; ++step) {
        machine.world.step();
        REQUIRE(length(machine.world.state(machine.b).velocity) < 50.0f);
    }
    CHECK(std::abs(machine.rope() - 10.0) < 0.1);
}

TEST_CASE("invalid pulleys throw with the value") {
    Atwood machine(1.0f, 1.0f, 1.0f);
    const auto refused = [&](PulleyJointDef def, const char* message) {
        CHECK_THROWS_WITH_AS(machine.world.create_joint(def), doctest::Contains(message), std::invalid_argument);
    };
    PulleyJointDef def = machine.def;
    def.ratio = 0.0f;
    refused(def, "joint ratio");
    def = machine.def;
    def.length = -1.0f;
    refused(def, "joint length");
    def = machine.def;
    def.ground_anchor_b.y = std::nan("");
    refused(def, "nan");
    def = machine.def;
    def.body_b = def.body_a;
    refused(def, "two bodies");
}
