// Sensors: each shape that enters has one begin event, and one end event when it leaves. Sensors stop nothing.
#include <doctest/doctest.h>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

const Shape kBox = make_box({1.0f, 1.0f});

BodyId add_sensor(World& world, DVec2 position, const Shape& shape, BodyType type = BodyType::static_body) {
    BodyDef def;
    def.type = type;
    def.pose.position = position;
    const BodyId body = world.create_body(def);
    world.add_shape(body, {.shape = shape, .sensor = true});
    return body;
}

// A ball of 20 cm at 100 m/s is 1.67 m farther in each step: of 100 phases 85 are on neither side of a sensor of 5 cm
// while it is in it.
// How many of 100 flights at 100 m/s, which begin at different phases of the step, enter and leave the sensor within
// one step.
int flights_within_a_step(ImpactModel impacts, bool is_moving) {
    int within_a_step = 0;
    WorldDef def;
    def.gravity = {};
    def.impacts = impacts;
    for (int phase = 0; phase < 100; ++phase) {
        World world(def);
        const BodyId sensor = add_sensor(world, {0.0, 0.0}, make_box({0.05f, 4.0f}),
                                         is_moving ? BodyType::kinematic_body : BodyType::static_body);
        if (is_moving) world.set_velocity(sensor, {-3.0f, 0.0f}, 0.0f);
        const BodyId ball = add_dynamic(world, {-4.0 - phase / 60.0, 0.0}, make_circle(0.1f));
        world.set_velocity(ball, {100.0f, 0.0f}, 0.0f);
        const BodyId beside = add_dynamic(world, {-4.0 - phase / 60.0, 3.0}, make_circle(0.1f));
        world.set_velocity(beside, {100.0f, 0.0f}, 0.0f);
        std::size_t begins = 0, ends = 0;
        for (int step = 0; step < 10; ++step) {
            world.step();
            const StepEvents& events = world.events();
            begins += events.sensor_begins.size();
            ends += events.sensor_ends.size();
            within_a_step += !events.sensor_begins.empty() && !events.sensor_ends.empty();
            for (const SensorEvent& event : events.sensor_begins) CHECK(world.body(event.visitor) == ball);
        }
        CHECK(begins == 1);
        CHECK(ends == 1);
        CHECK(world.state(ball).velocity == Vec2{100.0f, 0.0f});
    }
    return within_a_step;
}

}  // namespace

TEST_CASE("a sensor reports shapes that enter and leave in that step, and stops none") {
    for (const float speed : {3.0f, 60.0f}) {  // 5 cm and 1 m a step
        World world = weightless();
        const BodyId gate = add_sensor(world, {10.0, 0.0}, make_box({2.0f, 4.0f}));
        const BodyId ball = add_dynamic(world, {0.013, 0.0}, make_circle(0.5f));
        world.set_velocity(ball, {speed, 0.0f}, 0.0f);
        bool was_inside = false;
        int changes = 0;
        for (int step = 0; step < 360; ++step) {
            world.step();
            const double x = world.state(ball).pose.position.x;
            const bool is_inside = x > 8.5 && x < 11.5;
            CHECK(world.events().sensor_begins.size() == (is_inside && !was_inside ? 1u : 0u));
            CHECK(world.events().sensor_ends.size() == (was_inside && !is_inside ? 1u : 0u));
            changes += is_inside != was_inside;
            was_inside = is_inside;
            for (const SensorEvent& event : world.events().sensor_begins)
                CHECK(event == SensorEvent{world.shapes(gate)[0], world.shapes(ball)[0]});
        }
        CHECK(changes == 2);
        CHECK(world.state(ball).velocity == Vec2{speed, 0.0f});
        CHECK(world.contacts().empty());
    }
}

TEST_CASE("a sensor has no mass, detects kinematic bodies, and keeps bodies that sleep in it") {
    World world = weightless();
    const BodyId zone = add_sensor(world, {}, make_box({4.0f, 4.0f}));
    const BodyId ball = add_dynamic(world, {1.0, 0.0}, make_circle(0.5f));
    const BodyId lift = add_body(world, BodyType::kinematic_body, {-1.0, 0.0}, kBox);
    add_sensor(world, {0.0, 1.6}, kBox, BodyType::dynamic_body);  // sensors do not detect each other
    world.step();
    CHECK(world.events().sensor_begins.size() == 2);
    run(world, 120);
    CHECK_FALSE(world.is_awake(ball));
    CHECK(world.events().sensor_ends.empty());
    world.destroy_body(zone);
    world.step();
    CHECK(world.events().sensor_ends.size() == 2);
    World other;
    CHECK(other.mass(add_sensor(other, {}, kBox, BodyType::dynamic_body)).inertia == 0.0f);
    CHECK(world.is_valid(lift));
    world.audit();
}

TEST_CASE("a sensor that becomes static ends its overlap with static shapes") {
    World world;
    add_floor(world);
    const BodyId sensor = add_sensor(world, {0.0, 0.0}, kBox, BodyType::kinematic_body);
    world.step();
    CHECK(world.events().sensor_begins.size() == 1);
    world.set_type(sensor, BodyType::static_body);
    world.step();
    CHECK(world.events().sensor_ends.size() == 1);
}

TEST_CASE("a thin sensor detects a body that flies through it within a step, once") {
    for (const ImpactModel impacts : {ImpactModel::at_step_end, ImpactModel::in_order})
        for (const bool is_moving : {false, true}) {
            const int count = flights_within_a_step(impacts, is_moving);
            CHECK(count > 75);
            CHECK(count < 95);
        }
}

TEST_CASE("a thin sensor of a fast body detects a body that it passes within a step, once") {
    for (const ImpactModel impacts : {ImpactModel::at_step_end, ImpactModel::in_order})
        for (int phase = 0; phase < 100; ++phase) {
            CAPTURE(phase);
            World world({.gravity = {}, .impacts = impacts});
            const BodyId ball = add_dynamic(world, {-4.0 - phase / 60.0, 0.0}, make_circle(0.1f));
            world.add_shape(ball, {.shape = make_box({0.05f, 4.0f}), .sensor = true});
            world.set_velocity(ball, {100.0f, 0.0f}, 0.0f);
            add_dynamic(world, {0.0, 1.0}, make_circle(0.1f));
            std::size_t begins = 0;
            for (int step = 0; step < 10; ++step) {
                world.step();
                begins += world.events().sensor_begins.size();
            }
            CHECK(begins == 1);
        }
}

TEST_CASE("a body that is stopped before a sensor does not enter it") {
    World world = weightless();
    add_static(world, {0.0, 0.0}, make_box({0.1f, 4.0f}));
    add_sensor(world, {0.3, 0.0}, make_box({0.05f, 4.0f}));
    const BodyId ball = add_dynamic(world, {-2.0, 0.0}, make_circle(0.1f));
    world.set_velocity(ball, {300.0f, 0.0f}, 0.0f);
    for (int step = 0; step < 10; ++step) {
        world.step();
        CHECK(world.events().sensor_begins.empty());
    }
    CHECK(near(world.state(ball).pose.position.x, -0.15, absolute(0.01)));  // at the wall
}

TEST_CASE("a sensor that set_transform moves onto a near static shape detects it") {
    World world;
    add_static(world, {0.0, 0.0}, kBox);
    // First the boxes overlap by their margins only; then the shapes do.
    const BodyId sensor = add_sensor(world, {1.02, 0.0}, kBox, BodyType::kinematic_body);
    world.step();
    CHECK(world.events().sensor_begins.empty());
    world.set_transform(sensor, {{0.9, 0.0}, {}});
    world.step();
    CHECK(world.events().sensor_begins.size() == 1);
    world.set_transform(sensor, {{1.02, 0.0}, {}});
    world.step();
    CHECK(world.events().sensor_ends.size() == 1);
}
