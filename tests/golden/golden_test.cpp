// Two worlds, one with shapes, surfaces and joints of many kinds, against hashes in this file: so the builds of all
// compilers, optimisation levels and instruction sets are compared with each other.
//
// After a deliberate change of results, replace the hashes by those of any build. The test is about all builds
// agreeing.
#include <doctest/doctest.h>

#include <cstdint>
#include <random>

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
World make_everything() {
    Draw draw;
    World world;
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
World make_falling_hinges() {
    World world;
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

}  // namespace

TEST_CASE("falling hinges have the same hash in every build, in every step") {
    World world = make_falling_hinges();
    std::uint64_t all_steps = 0;
    for (int step = 0; step < 400; ++step) {
        world.step();
        all_steps = 31 * all_steps + world.state_hash();
    }
    CHECK(all_steps == 14243993751078487432u);
    world.audit();
}

TEST_CASE("every build computes the same bits") {
    World world = make_everything();
    run(world, 60);
    CHECK(world.state_hash() == 9978567498663484650u);
    run(world, 540);
    CHECK(world.state_hash() == 9147743189822970278u);
    CHECK(world.counters().contacts > 20);
}
