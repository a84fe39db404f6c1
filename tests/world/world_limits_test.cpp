// The limits of world_limits() are those of the step.
#include <doctest/doctest.h>

#include "support/near.hpp"
#include "tumble/shape.hpp"
#include "tumble/world.hpp"
#include "tumble/world_def.hpp"

using namespace tumble;
using namespace tumble::test;

TEST_CASE("damped bodies slower than rest_speed fall asleep, in worlds of all scales") {
    for (const float scale : {0.02f, 1.0f, 50.0f}) {
        CAPTURE(scale);
        const auto sleeps = [&](float part) {
            const WorldDef def{.gravity = {}, .scale = scale};
            World world(def);
            const BodyId body = world.create_body({.velocity = {part * world_limits(def).rest_speed, 0.0f}});
            world.add_shape(body, {.shape = make_circle(0.5f * scale)});
            world.set_damping(body, 1e-5f, 0.0f);  // without damping it would drift, and stay awake
            for (int i = 0; i < 600; ++i) world.step();
            return !world.is_awake(body);
        };
        CHECK(sleeps(0.99f));
        CHECK_FALSE(sleeps(1.01f));
    }
}

TEST_CASE("a body faster than max_speed is clamped to it, in worlds of all scales") {
    for (const float scale : {0.02f, 1.0f, 50.0f}) {
        CAPTURE(scale);
        const WorldDef def{.gravity = {}, .scale = scale};
        const float limit = world_limits(def).max_speed;
        World world(def);
        const BodyId slow = world.create_body({.velocity = {0.99f * limit, 0.0f}});
        const BodyId fast =
            world.create_body({.pose = {{0.0, 100.0 * double{scale}}, {}}, .velocity = {0.0f, 3.0f * limit}});
        for (const BodyId id : {slow, fast}) world.add_shape(id, {.shape = make_circle(0.5f * scale)});
        world.step();
        CHECK(world.state(slow).velocity.x == 0.99f * limit);
        CHECK(near(world.state(fast).velocity.y, double{limit}, kFloat));
    }
}

TEST_CASE("a body rotates by max_rotation in a step at most, unless it may rotate fast") {
    const WorldDef def{.gravity = {}};
    const float limit = world_limits(def).max_rotation * def.steps_per_second;
    const auto spin_after_step = [&](float spin, bool may) {
        World world(def);
        const BodyId body = world.create_body({.angular_velocity = spin, .allow_fast_rotation = may});
        world.add_shape(body, {.shape = make_circle(0.5f)});
        world.step();
        return double{world.state(body).angular_velocity};
    };
    CHECK(spin_after_step(0.99f * limit, false) == double{0.99f * limit});
    CHECK(near(spin_after_step(3.0f * limit, false), double{limit}, kFloat));
    CHECK(spin_after_step(3.0f * limit, true) == double{3.0f * limit});
}

TEST_CASE("joint springs are no stiffer than stiffest_spring") {
    for (const int substeps : {2, 4, 9}) {
        CAPTURE(substeps);
        const auto hash = [&](float part) {
            const WorldDef def{.substeps = substeps};
            World world(def);
            const BodyId pin = world.create_body({.type = BodyType::static_body}),
                         bob = world.create_body({.pose = {{1.0, 0.0}, {}}});
            world.add_shape(bob, {.shape = make_circle(0.2f)});
            world.create_joint(DistanceJointDef{.body_a = pin,
                                                .body_b = bob,
                                                .length = 1.0f,
                                                .spring = JointSpring{part * world_limits(def).stiffest_spring, 0.5f}});
            for (int i = 0; i < 30; ++i) world.step();
            return world.state_hash();
        };
        CHECK(hash(1.0f) == hash(7.0f));
        CHECK(hash(1.0f) != hash(0.99f));
    }
}
