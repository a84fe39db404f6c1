// Invalid arguments throw with the value printed, and leave the world as it was.
#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::string refusal(const std::function<void()>& call) {
    try {
        call();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("definitions out of range throw with the value") {
    World world;
    const BodyId body = add_dynamic(world, {}, make_circle(1.0f));
    const BodyId other = add_static(world, {0.0, -3.0}, make_circle(1.0f));
    const std::uint64_t before = world.state_hash();

    CHECK(refusal([] { World(WorldDef{.gravity = {0.0f, kNan}}); }) == "gravity must be finite, got (0, nan)");
    CHECK(refusal([] { World(WorldDef{.steps_per_second = 0.0f}); }) ==
          "steps_per_second must be finite and greater than 0, got 0");
    CHECK(refusal([] { World(WorldDef{.substeps = 0}); }) == "substeps must be at least 1, got 0");
    CHECK(refusal([&] {
              world.create_body({.pose = {{kInfinity, 0.0}, {}}});
          }) == "body position must be finite, got (inf, 0)");
    CHECK(refusal([&] {
              world.create_body({.pose = {{}, {1.0f, 0.5f}}});
          }) == "body rotation (cosine, sine) must be of length 1, got (1, 0.5)");
    CHECK(refusal([&] { world.create_body({.linear_damping = -2.0f}); }) ==
          "body linear_damping must be finite and not negative, got -2");
    CHECK(refusal([&] { world.add_shape(body, {}); }) == "shape must have at least 1 vertex, got 0");
    CHECK(refusal([&] {
              world.add_shape(body, {make_circle(1.0f), {.restitution = 1.5f}});
          }) == "shape restitution must be between 0 and 1, got 1.5");
    CHECK(refusal([&] {
              world.add_shape(body, {make_circle(1.0f), {.friction = -0.5f}});
          }) == "shape friction must be finite and not negative, got -0.5");
    CHECK(refusal([&] {
              world.set_velocity(body, {kNan, 1.0f}, 0.0f);
          }) == "body velocity must be finite, got (nan, 1)");
    CHECK(refusal([&] {
              world.set_velocity(other, {1.0f, 1.0f}, 0.0f);
          }) == "body 1 is static or disabled: it has no velocity to set");
    CHECK(refusal([&] { world.create_joint(DistanceJointDef{.body_a = body, .body_b = other, .length = 0.0f}); }) ==
          "joint length must be finite and greater than 0, got 0");
    CHECK(refusal([&] { world.create_joint(RevoluteJointDef{.body_a = body, .body_b = body}); }) ==
          "joint needs two bodies, got body 0 twice");
    CHECK(refusal([&] { world.create_joint(RevoluteJointDef{.body_a = body}); }) ==
          "body id is the default one, which is of no body");
    const std::string unknown =
        "body id is unknown: no body of this world has had it so far (index 9, generation 0); it is of another world";
    const std::string of_later_time = ", or of a time after the state that was restored";
    CHECK(refusal([&] { world.state({9, 0}); }) == unknown);
    const World loaded = World::load(world.save());
    CHECK(refusal([&] { loaded.state({9, 0}); }) == unknown + of_later_time);
    World assigned;
    assigned.assign(world);
    CHECK(refusal([&] { assigned.state({9, 0}); }) == unknown + of_later_time);

    CHECK(world.state_hash() == before);
    CHECK(world.bodies().size() == 2);
    CHECK(world.joints().empty());
    world.audit();
}

TEST_CASE("a world that diverges reports the body, and can still be read") {
    World world(WorldDef{.steps_per_second = 0.1f});  // 10 s at 3e38 m/s: more than a float can represent
    add_static(world, {}, make_circle(1.0f));
    const BodyId lost = world.create_body({.type = BodyType::kinematic_body, .velocity = {3e38f, 0.0f}});
    try {
        world.step();
        FAIL("an infinite position went unnoticed");
    } catch (const SimulationDiverged& error) {
        CHECK(error.body == lost);
        CHECK(error.step == world.step_count());
    }
    CHECK_THROWS_AS(world.step(), SimulationDiverged);
    CHECK(world.bodies().size() == 2);
    CHECK_NOTHROW(world.state(lost));
    // What is changed after it keeps the structures of the world whole: a body without a pose has no box.
    const ShapeId shape = world.add_shape(lost, {.shape = make_circle(1.0f)});
    world.audit();
    world.set_enabled(lost, false);
    world.set_enabled(lost, true);
    world.set_filter(shape, {.mask = 3});
    world.audit();
    world.set_transform(lost, {{5.0, 0.0}, {}});
    CHECK(world.overlap_box({4.0, -1.0}, {6.0, 1.0}).size() == 1);
    world.destroy_body(lost);
    world.audit();
}

TEST_CASE("a dynamic body of any shapes has a finite, positive mass") {
    for (const float radius : {1e-30f, 1e-19f, 1e-10f, 1e-3f, 1e19f, 3e38f})
        for (const float density : {0.0f, 1e-38f, 1.0f, 3e38f}) {
            World world = weightless();
            const BodyId body = add_dynamic(world, {}, make_circle(radius), {.density = density});
            CHECK(world.mass(body).mass > 0.0f);
            CHECK(std::isfinite(world.mass(body).mass));
            world.set_velocity(body, {1.0f, 0.0f}, 1.0f);
            CHECK_NOTHROW(run(world, 2));
            world.audit();
        }
}

// The inverse of a mass below FLT_MIN is that of FLT_MIN: 1e-40 kg has the inertia of 1.2e-38 kg.
TEST_CASE("a body of the least mass is pushed out of a heavier one, and has the velocity of its impulse") {
    constexpr float kLightest = std::numeric_limits<float>::min();
    World world = weightless();
    const BodyId body = add_dynamic(world, {}, make_circle(0.5f));
    const BodyId heavy = add_dynamic(world, {0.9, 0.0}, make_circle(0.5f));
    world.set_mass(body, BodyMass{1e-40f, {}, 1e-42f});
    world.set_allow_sleep(body, false);
    run(world, 60);
    // They overlap by 0.1 m. The contact pushes the light one out until what is left is a slop of less than 1 mm.
    CHECK(near(world.state(body).pose.position.x, -0.1, absolute(0.001)));
    CHECK(world.state(heavy).pose.position.x == 0.9);
    world.apply_impulse(body, {-2.0f * kLightest, 0.0f});
    CHECK(near(world.state(body).velocity.x, -2.0, kFloat));
    world.step();
    CHECK(near(world.state(body).velocity.x, -2.0, kFloat));
    world.audit();
}

TEST_CASE("a joint impulse that is not finite is a divergence, even between static bodies") {
    World world;
    const BodyId a = add_static(world, {0.0, 5.0}, make_circle(1.0f)),
                 b = add_static(world, {1.0, 5.0}, make_circle(1.0f));
    world.create_joint(DistanceJointDef{.body_a = a, .body_b = b, .anchor_b = {1e30f, 1e30f}, .length = 1.0f});
    CHECK_THROWS_AS(world.step(), SimulationDiverged);
}
