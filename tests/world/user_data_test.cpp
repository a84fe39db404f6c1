// Numbers of the caller's on bodies, shapes and joints, and the states of all bodies as arrays.
#include <doctest/doctest.h>

#include <vector>

#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

TEST_CASE("user data stays with its body, shape and joint, in definitions and in snapshots") {
    World world;
    const BodyId ground = world.create_body({.type = BodyType::static_body, .user_data = 7});
    const BodyId ball = world.create_body({.pose = {{0.0, 3.0}, {}}});
    const ShapeId shape = world.add_shape(ball, {.shape = make_circle(0.5f), .user_data = ~std::uint64_t{0}});
    const JointId joint = world.create_joint(RevoluteJointDef{.body_a = ground, .body_b = ball, .user_data = 5});
    CHECK(world.user_data(ground) == 7);
    CHECK(world.user_data(ball) == 0);
    CHECK(world.user_data(shape) == ~std::uint64_t{0});
    CHECK(world.user_data(joint) == 5);
    world.set_user_data(ball, 1);
    world.set_user_data(shape, 2);
    world.set_user_data(joint, 3);
    CHECK(world.definition(ball).user_data == 1);
    CHECK(std::get<RevoluteJointDef>(world.joint(joint)).user_data == 3);

    const World loaded = World::load(world.save());
    CHECK(loaded.user_data(ground) == 7);
    CHECK(loaded.user_data(ball) == 1);
    CHECK(loaded.user_data(shape) == 2);
    CHECK(loaded.user_data(joint) == 3);

    world.destroy_body(ball);
    CHECK_THROWS_AS(world.user_data(ball), std::invalid_argument);
    CHECK_THROWS_AS(world.set_user_data(shape, 1), std::invalid_argument);
    CHECK_THROWS_AS(world.user_data(joint), std::invalid_argument);
    const BodyId next = world.create_body({});  // takes the index of the ball, not its data
    CHECK(next.index == ball.index);
    CHECK(world.user_data(next) == 0);
}

TEST_CASE("user data changes no bit of the simulation") {
    const auto hash_with = [](std::uint64_t data) {
        World world;
        add_floor(world);
        const BodyId ball = add_dynamic(world, {0.1, 3.0}, make_box({1.0f, 1.0f}), {}, 0.3);
        for (int i = 0; i < 60; ++i) {
            world.set_user_data(ball, data * static_cast<std::uint64_t>(i));
            world.step();
        }
        return world.state_hash();
    };
    CHECK(hash_with(0) == hash_with(12345));
}

TEST_CASE("the arrays of states have what state() answers, in the order of bodies()") {
    World world;
    add_floor(world);
    const BodyId first = add_dynamic(world, {0.0, 4.0}, make_box({1.0f, 1.0f}), {}, 0.4);
    add_dynamic(world, {2.0, 5.0}, make_circle(0.5f));
    add_dynamic(world, {4.0, 6.0}, make_circle(0.5f));
    for (int i = 0; i < 50; ++i) world.step();
    world.destroy_body(first);
    const std::size_t count = world.bodies().size();
    REQUIRE(count == 3);
    std::vector<DVec2> positions(count);
    std::vector<double> angles(count);
    std::vector<Vec2> velocities(count);
    std::vector<float> turning(count);
    world.read_states({positions, angles, velocities, turning});
    for (std::size_t i = 0; i < count; ++i) {
        const BodyState state = world.state(world.bodies()[i]);
        CHECK(positions[i] == state.pose.position);
        CHECK(angles[i] == angle(state.pose.rotation));
        CHECK(velocities[i] == state.velocity);
        CHECK(turning[i] == state.angular_velocity);
    }
    std::vector<double> others(count, -1.0);
    world.read_states({.angles = others});
    CHECK(others == angles);
    std::vector<float> too_few(count - 1);
    CHECK_THROWS_WITH_AS(world.read_states({.angular_velocities = too_few}),
                         "angular_velocities needs one entry for each body: it has 2, the world has 3 bodies",
                         std::invalid_argument);
}

TEST_CASE("the velocity at a point is that of the centre of mass and of the rotation about it") {
    World world({.gravity = {}});
    const BodyId body = world.create_body({.pose = {{1.0, 2.0}, make_rotation_degrees(90.0)}});
    world.add_shape(body, {.shape = make_circle(0.5f, {2.0f, 0.0f})});  // its centre of mass is at (1, 4)
    world.set_velocity(body, {3.0f, -1.0f}, 2.0f);
    CHECK(world.velocity_at(body, {1.0, 4.0}) == Vec2{3.0f, -1.0f});
    CHECK(world.velocity_at(body, {1.5, 4.0}) == Vec2{3.0f, 0.0f});   // 0.5 m to its right: +1 m/s upwards
    CHECK(world.velocity_at(body, {1.0, 3.0}) == Vec2{5.0f, -1.0f});  // 1 m below it: +2 m/s to the right
    CHECK_THROWS_AS(world.velocity_at(body, {std::nan(""), 0.0}), std::invalid_argument);
    CHECK(world.velocity_at(world.create_body({.type = BodyType::static_body}), {5.0, 5.0}) == Vec2{});
}
