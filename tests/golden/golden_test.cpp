// Worlds with shapes, surfaces and joints of many kinds, direct joints, impacts and a wall that wakes, against hashes
// in this file: so the builds of all compilers, optimisation levels and instruction sets are compared with each other.
//
// After a deliberate change of results, replace the hashes by those of any build. The test is about all builds
// agreeing.
#include <doctest/doctest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "support/environment.hpp"
#include "support/thread_tasks.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

struct Draw {
    std::mt19937 random{2026};

    // In [0, 1): from the generator's integers, as distributions differ between standard libraries.
    float next() { return static_cast<float>(random() >> 8) * 0x1p-24f; }
    float between(float low, float high) { return low + (high - low) * next(); }
};

Shape draw_shape(Draw& draw, int kind) {
    const float size = draw.between(0.2f, 0.5f);
    switch (kind) {
        case 0: return make_circle(size);
        case 1: return make_box({2.0f * size, size}, 0.1f * size);
        case 2: return make_capsule({-size, 0.0f}, {size, 0.1f}, 0.15f);
        default: {
            const Vec2 corners[] = {{-size, -size},
                                    {size, -0.5f * size},
                                    {1.1f * size, 0.4f * size},
                                    {0.2f * size, size},
                                    {-size, 0.3f * size}};
            return make_polygon(corners);
        }
    }
}

// A joint of any kind but pulley, gear and filter, with springs, motors and limits.
void add_joint(World& world, int kind, BodyId a, BodyId b) {
    const Vec2 right{0.5f, 0.0f}, left{-0.5f, 0.1f};
    const JointLimits limits{-0.3f, 0.4f};
    const JointSpring spring{3.0f, 0.3f};
    switch (kind) {
        case 0: world.create_joint(DistanceJointDef{.body_a = a, .body_b = b, .length = 0.9f}); break;
        case 1:
            world.create_joint(RevoluteJointDef{
                .body_a = a, .body_b = b, .anchor_a = right, .anchor_b = left, .limits = limits, .spring = spring});
            break;
        case 2:
            world.create_joint(PrismaticJointDef{.body_a = a,
                                                 .body_b = b,
                                                 .anchor_a = right,
                                                 .anchor_b = left,
                                                 .axis_a = {1.0f, 2.0f},
                                                 .limits = limits,
                                                 .motor = LinearMotor{0.5f, 20.0f}});
            break;
        case 3:
            world.create_joint(
                WeldJointDef{.body_a = a, .body_b = b, .anchor_a = right, .anchor_b = left, .angular_spring = spring});
            break;
        case 4:
            world.create_joint(WheelJointDef{.body_a = a,
                                             .body_b = b,
                                             .anchor_a = right,
                                             .anchor_b = left,
                                             .motor = AngularMotor{3.0f, 5.0f},
                                             .spring = spring});
            break;
        case 5:
            world.create_joint(MotorJointDef{
                .body_a = a, .body_b = b, .anchor_a = right, .max_force = 5.0f, .max_torque = 2.0f, .spring = spring});
            break;
        case 6:
            world.create_joint(MouseJointDef{.body_a = a, .body_b = b, .anchor_a = right, .max_force = 20.0f});
            break;
        default:
            world.create_joint(RevoluteJointDef{.body_a = a,
                                                .body_b = b,
                                                .anchor_a = right,
                                                .anchor_b = left,
                                                .motor = AngularMotor{-2.0f, 3.0f},
                                                .break_force = 400.0f});
    }
}

// Far from the origin: a bowl with a belt, bodies of every shape and surface, chains of them in joints, a spinner.
World make_everything(ImpactModel impacts) {
    Draw draw;
    World world({.impacts = impacts});
    const DVec2 far{700.0, -300.0};
    add_static(world, far, make_box({12.0f, 1.0f}), {.tangent_speed = 1.0f}, 0.1);
    add_static(world, far + DVec2{-8.0, 3.0}, make_capsule({0.0f, 0.0f}, {2.0f, -3.0f}, 0.3f), {.friction = 0.1f});
    add_static(world, far + DVec2{8.0, 3.0}, make_segment({0.0f, 0.0f}, {-2.0f, -3.0f}));
    const BodyId spinner =
        add_body(world, BodyType::kinematic_body, far + DVec2{0.0, 2.5}, make_box({5.0f, 0.3f}), {.friction = 1.0f});
    world.set_velocity(spinner, {}, 1.5f);
    BodyId before{};
    for (int i = 0; i < 80; ++i) {
        const Shape shape = draw_shape(draw, i % 4);
        SurfaceMaterial surface;
        surface.density = draw.between(0.5f, 4.0f);
        surface.friction = draw.next();
        surface.restitution = 0.5f * draw.next();
        surface.rolling_resistance = 0.1f * draw.next();
        const double turn = static_cast<double>(draw.between(-3.0f, 3.0f));
        const BodyId body = add_dynamic(world, far + DVec2{-4.5 + i % 10, 5.0 + i / 10}, shape, surface, turn);
        if (i % 10 >= 2) add_joint(world, i % 10 - 2, before, body);
        before = body;
    }
    return world;
}

// Columns of boxes, each hinged to the next one's edge and sprung, that fall over each other: chaotic enough to show
// any bit that differs.
World make_falling_hinges(ImpactModel impacts) {
    World world({.impacts = impacts});
    add_floor(world);
    const Shape box = make_box({0.5f, 0.5f}, 0.05f);
    for (int column = 0; column < 4; ++column) {
        BodyId before{};
        for (int row = 0; row < 20; ++row) {
            const DVec2 position{1.2 * column + 0.2 * (row % 5), 0.3 + 0.55 * row};
            const BodyId body = add_dynamic(world, position, box, {.friction = 0.3f}, 0.1 * (row % 3) - 0.1);
            if (row % 2 == 1)
                world.create_joint(RevoluteJointDef{.body_a = before,
                                                    .body_b = body,
                                                    .anchor_a = {0.25f, 0.25f},
                                                    .anchor_b = {0.05f, -0.3f},
                                                    .limits = JointLimits{-0.3f, 0.6f},
                                                    .spring = JointSpring{0.5f, 0.5f},
                                                    .collide_connected = true});
            before = body;
        }
    }
    return world;
}

constexpr JointLimits kBend{-0.5f, 0.7f};
constexpr int kLinks = 12;

// Links of 0.5 m that start level, and a ball of some 300 times their mass. The fourth joint has limits, and a motor
// drives the second one.
void add_heavy_chain(World& world, DVec2 pivot) {
    BodyId before = add_static(world, pivot, make_circle(0.05f));
    Vec2 anchor{};
    for (int i = 0; i < kLinks; ++i) {
        RevoluteJointDef joint{.body_a = before, .anchor_a = anchor, .anchor_b = {-0.25f, 0.0f}};
        joint.body_b = add_dynamic(world, pivot + DVec2{0.25 + 0.5 * i, 0.0}, make_box({0.5f, 0.1f}));
        if (i == 1) joint.motor = AngularMotor{2.0f, 1.0f};
        if (i == 3) joint.limits = kBend;
        world.create_joint(joint);
        before = joint.body_b;
        anchor = {0.25f, 0.0f};
    }
    const BodyId ball =
        add_dynamic(world, pivot + DVec2{0.5 * kLinks + 0.7, 0.0}, make_circle(0.7f), {.density = 10.0f});
    world.create_joint(
        RevoluteJointDef{.body_a = before, .body_b = ball, .anchor_a = anchor, .anchor_b = {-0.7f, 0.0f}});
}

// A trunk with a welded head and four limbs of two parts. All hinges have limits, one of them a motor.
void add_ragdoll(World& world, DVec2 position) {
    const BodyId trunk = add_dynamic(world, position, make_capsule({0.0f, -0.3f}, {0.0f, 0.3f}, 0.15f));
    const BodyId head = add_dynamic(world, position + DVec2{0.0, 0.7}, make_circle(0.2f));
    world.create_joint(
        WeldJointDef{.body_a = trunk, .body_b = head, .anchor_a = {0.0f, 0.5f}, .anchor_b = {0.0f, -0.2f}});
    const Shape part = make_capsule({0.0f, -0.2f}, {0.0f, 0.2f}, 0.07f);
    for (int limb = 0; limb < 4; ++limb) {
        const float side = limb % 2 == 0 ? 1.0f : -1.0f;
        const Vec2 joint_at = limb < 2 ? Vec2{0.3f * side, 0.3f} : Vec2{0.1f * side, -0.4f};
        RevoluteJointDef upper{.body_a = trunk, .anchor_a = joint_at, .anchor_b = {0.0f, 0.25f}, .limits = kBend};
        upper.body_b = add_dynamic(world, position + DVec2(joint_at) - DVec2{0.0, 0.25}, part);
        if (limb == 1) upper.motor = AngularMotor{-4.0f, 2.0f};
        world.create_joint(upper);
        const BodyId lower = add_dynamic(world, position + DVec2(joint_at) - DVec2{0.0, 0.75}, part);
        world.create_joint(RevoluteJointDef{.body_a = upper.body_b,
                                            .body_b = lower,
                                            .anchor_a = {0.0f, -0.25f},
                                            .anchor_b = {0.0f, 0.25f},
                                            .limits = kBend});
    }
}

// The ragdolls fall on to the floor, and the chain with its ball on to them.
World make_direct_joints() {
    WorldDef def;
    def.joints = JointSolver::direct;
    World world(def);
    add_floor(world);
    add_heavy_chain(world, {-6.0, 4.2});
    for (int i = 0; i < 3; ++i) add_ragdoll(world, {-2.0 + 1.1 * i, 1.6 + 0.3 * i});
    return world;
}

// Discs, boxes and capsules of several materials that fall into a pit with a paddle.
World make_impacts() {
    WorldDef def;
    def.impacts = ImpactModel::in_order;
    World world(def);
    add_floor(world, {.restitution = 0.5f});
    for (const double x : {-4.0, 4.0}) add_static(world, {x, 3.0}, make_box({1.0f, 6.0f}), {.restitution = 1.0f});
    const BodyId paddle = add_body(world, BodyType::kinematic_body, {0.0, 1.0}, make_box({2.0f, 0.1f}));
    world.set_velocity(paddle, {}, 20.0f);
    const Shape shapes[] = {make_circle(0.2f), make_box({0.4f, 0.3f}), make_capsule({-0.2f, 0.0f}, {0.2f, 0.0f}, 0.1f)};
    for (int i = 0; i < 24; ++i) {
        const float restitution = 0.25f * static_cast<float>(i % 5);
        const BodyId body = add_dynamic(world, {-2.4 + 0.9 * (i % 6), 3.0 + 0.8 * (i / 6)}, shapes[i % 3],
                                        {.friction = 0.3f, .restitution = restitution}, 0.3 * i);
        world.set_velocity(body, {static_cast<float>(i % 7 - 3), -8.0f}, 0.5f * static_cast<float>(i % 4));
    }
    return world;
}

// A hash of all states of a run.
// A wall of boxes that sleep one by one, and a block that hits it: the boxes wake in rounds.
World make_sleeping_wall(ImpactModel impacts) {
    WorldDef def;
    def.impacts = impacts;
    World world(def);
    add_floor(world);
    for (int column = 0; column < 12; ++column)
        for (int row = 0; row < 8; ++row) {
            BodyDef box;
            box.pose.position = {0.4 * column, 0.2 + 0.4 * row};
            box.awake = false;
            world.add_shape(world.create_body(box), {.shape = make_box({0.4f, 0.4f})});
        }
    const BodyId block = add_dynamic(world, {-1.2, 1.3}, make_box({1.0f, 1.0f}), {.density = 5.0f});
    world.set_velocity(block, {20.0f, 0.0f}, 1.0f);
    return world;
}

std::uint64_t hash_steps(World& world, int steps) {
    std::uint64_t all_steps = 0;
    for (int step = 0; step < steps; ++step) {
        world.step();
        all_steps = 31 * all_steps + world.state_hash();
    }
    return all_steps;
}

// The threads that each world is stepped on: TUMBLE_GOLDEN_THREADS=n means n of them.
std::vector<Threads> golden_threads() {
    const int count = from_environment("TUMBLE_GOLDEN_THREADS", 0);
    if (count > 0) return {eager_threads(count)};
    return {Threads{}, eager_threads(3)};
}

}  // namespace

TEST_CASE("impacts in order have the same hash in every build, in every step, on any number of threads") {
    for (const Threads& threads : golden_threads()) {
        World world = make_impacts();
        world.set_threads(threads);
        CHECK(hash_steps(world, 120) == 17183631256537898746u);
        CHECK(world.counters().contacts > 5);
        world.audit();
    }
}

TEST_CASE("falling hinges have the same hash in every build, in every step, on any number of threads") {
    for (const Threads& threads : golden_threads()) {
        World world = make_falling_hinges(ImpactModel::in_order);
        world.set_threads(threads);
        CHECK(hash_steps(world, 400) == 17143909321809833653u);
        world.audit();
    }
}

TEST_CASE("impacts at the step's end have the same hash in every build, in every step, on any number of threads") {
    for (const Threads& threads : golden_threads()) {
        World hinges = make_falling_hinges(ImpactModel::at_step_end);
        hinges.set_threads(threads);
        CHECK(hash_steps(hinges, 400) == 13121310352779148928u);
        World world = make_everything(ImpactModel::at_step_end);
        world.set_threads(threads);
        run(world, 600);
        CHECK(world.state_hash() == 12080751227381314878u);
    }
}

TEST_CASE("a wall that wakes has the same hash in every build, in every step, on any number of threads") {
    for (const Threads& threads : golden_threads()) {
        World in_order = make_sleeping_wall(ImpactModel::in_order);
        in_order.set_threads(threads);
        CHECK(hash_steps(in_order, 60) == 8013429504919540733u);
        CHECK(in_order.awake_bodies().size() == 97);
        in_order.audit();
        World at_step_end = make_sleeping_wall(ImpactModel::at_step_end);
        at_step_end.set_threads(threads);
        CHECK(hash_steps(at_step_end, 60) == 14511434372617028048u);
        at_step_end.audit();
    }
}

TEST_CASE("every build computes the same bits, on any number of threads") {
    for (const Threads& threads : golden_threads()) {
        World world = make_everything(ImpactModel::in_order);
        world.set_threads(threads);
        run(world, 60);
        CHECK(world.state_hash() == 4979852539502635061u);
        run(world, 540);
        CHECK(world.state_hash() == 8529769667566284203u);
        CHECK(world.counters().contacts > 20);
    }
}

TEST_CASE("direct joints have the same hash in every build, in every step, on any number of threads") {
    for (const Threads& threads : golden_threads()) {
        World world = make_direct_joints();
        world.set_threads(threads);
        CHECK(hash_steps(world, 60) == 7616179333584341215u);
        CHECK(world.counters().contacts > 10);
        world.audit();
    }
}
