// Bodies that are locked along an axis, or against rotation.
#include <doctest/doctest.h>

#include <cmath>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

const Shape kBox = make_box({1.0f, 1.0f});

BodyId add_locked(World& world, DVec2 position, BodyLocks locks, const Shape& shape = kBox) {
    BodyDef def;
    def.pose.position = position;
    def.locks = locks;
    const BodyId id = world.create_body(def);
    world.add_shape(id, {shape});
    return id;
}

}  // namespace

TEST_CASE("a body keeps its coordinate on a locked axis under any force, and is free on the other axis") {
    World world;
    add_floor(world);
    const BodyId falls = add_locked(world, {0.25, 3.0}, {.x = true});
    const BodyId hangs = add_locked(world, {5.25, 3.0}, {.y = true});
    world.apply_impulse(falls, {50.0f, 0.0f}, {0.25, 3.2});
    world.apply_impulse(hangs, {2.0f, 30.0f}, {5.25, 3.0});
    run(world, 30);
    CHECK(world.state(falls).pose.position.x == 0.25);
    CHECK(near(world.state(falls).velocity.y, -5.0, float_sum(240)));
    CHECK(world.state(hangs).pose.position.y == 3.0);
    CHECK(world.state(hangs).velocity == Vec2{2.0f, 0.0f});
}

TEST_CASE("a body with locked rotation stays upright where another tips over") {
    World world;
    add_floor(world);
    const BodyId fixed = add_locked(world, {0.0, 1.0}, {.rotation = true}, make_box({0.4f, 2.0f}));
    const BodyId free = add_dynamic(world, {5.0, 1.0}, make_box({0.4f, 2.0f}));
    for (const BodyId body : {fixed, free}) {
        const DVec2 top = world.state(body).pose.position + DVec2{0.0, 0.9};
        world.apply_impulse(body, {2.0f, 0.0f}, top);
    }
    run(world, 120);
    CHECK(world.state(fixed).pose.rotation == Rotation{});
    CHECK(near(world.state(fixed).pose.position.y, 1.0, absolute(kRestingDepth)));
    CHECK(std::abs(angle(world.state(free).pose.rotation)) > 1.0);
}

TEST_CASE("locks apply to dynamic bodies only: a kinematic one keeps the velocity that is set") {
    World world;
    BodyDef def{.type = BodyType::kinematic_body, .velocity = {1.0f, 0.0f}};
    def.locks = {.x = true, .rotation = true};
    const BodyId body = world.create_body(def);
    CHECK(world.state(body).velocity == Vec2{1.0f, 0.0f});
    world.set_velocity(body, {2.0f, 3.0f}, 0.5f);
    CHECK(world.state(body).velocity == Vec2{2.0f, 3.0f});
    CHECK(world.state(body).angular_velocity == 0.5f);
    world.set_type(body, BodyType::dynamic_body);  // the locks apply again
    CHECK(world.state(body).velocity == Vec2{0.0f, 3.0f});
    CHECK(world.state(body).angular_velocity == 0.0f);
}

// The platform cannot sink under ten times its weight: the ball rests on it as on the ground, and sags by g / w^2,
// w = 2 pi 42.6: 0.14 mm.
TEST_CASE("a ball rests on a platform that is locked against falling") {
    World world;
    const BodyId platform = add_locked(world, {0.0, 0.0}, {.y = true, .rotation = true}, make_box({4.0f, 1.0f}));
    const BodyId ball = add_dynamic(world, {0.0, 1.5}, make_circle(0.5f), {.density = 20.0f});
    world.set_allow_sleep(ball, false);
    run(world, 240);
    CHECK(world.state(platform).pose.position.y == 0.0);
    const double omega = 2.0 * kPi * 42.6;
    CHECK(near(world.state(ball).pose.position.y, 1.0 - 10.0 / (omega * omega), absolute(1e-6)));
    CHECK(std::abs(world.state(ball).velocity.y) < 1e-3);
    CHECK(world.contacts().size() == 1);
}

// A slider by two locks and a hinge: the weight hangs from a body that only moves along x, and swings it.
TEST_CASE("joints constrain bodies that are locked along one axis") {
    World world;
    const BodyId trolley = add_locked(world, {0.0, 4.0}, {.y = true, .rotation = true});
    const BodyId weight = add_dynamic(world, {1.2, 2.4}, make_circle(0.2f), {.density = 8.0f});
    world.create_joint(RevoluteJointDef{.body_a = trolley, .body_b = weight, .anchor_b = {-1.2f, 1.6f}});
    double farthest = 0.0;
    for (int step = 0; step < 240; ++step) {
        world.step();
        const DVec2 apart = world.state(weight).pose.position - world.state(trolley).pose.position;
        farthest = std::max(farthest, std::abs(length(apart) - 2.0));
        CHECK(world.state(trolley).pose.position.y == 4.0);
    }
    CHECK(farthest < 0.01);
    CHECK(std::abs(world.state(trolley).pose.position.x) > 0.01);  // it was pulled along
}

TEST_CASE("a body stops when its axis is locked, and falls on when it is free again") {
    World world;
    const BodyId body = add_dynamic(world, {0.0, 10.0}, kBox);
    run(world, 30);
    world.set_locks(body, {.x = true, .y = true, .rotation = true});
    CHECK(world.state(body).velocity == Vec2{});
    const DVec2 locked_at = world.state(body).pose.position;
    run(world, 30);
    CHECK(world.state(body).pose.position == locked_at);
    world.set_locks(body, {});
    run(world, 6);
    CHECK(near(world.state(body).velocity.y, -1.0, float_sum(240)));
}
