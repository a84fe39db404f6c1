// How often the narrow phase collides a pair in full: World::counters().collided.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// A thin bar at 45 degrees through the origin, and a ball whose box is inside that of the bar.
struct BarAndBall {
    explicit BarAndBall(Vec2 velocity) {
        add_static(world, {}, make_box({20.0f, 0.2f}), {}, 0.25 * kPi);
        ball = add_dynamic(world, {2.0, -2.0}, make_circle(0.25f));
        world.set_velocity(ball, velocity, 0.0f);
    }
    World world = weightless();
    BodyId ball;
};

}  // namespace

TEST_CASE("a pair that stays apart is collided once") {
    // The ball moves by 0.5 m; its gap is 2 sqrt(2) - 0.35 m.
    BarAndBall scene({0.5f, 0.5f});
    std::int64_t collided = 0;
    for (int i = 0; i < 60; ++i) {
        scene.world.step();
        CHECK(scene.world.counters().pairs == 1);
        collided += scene.world.counters().collided;
    }
    CHECK(collided == 1);
}

TEST_CASE("a pair that comes near is collided again in time") {
    for (const float speed : {0.5f, 5.0f, 50.0f}) {
        CAPTURE(speed);
        BarAndBall scene({-speed, speed});
        const int steps = static_cast<int>(60.0f * 3.0f / speed);
        for (int i = 0; i < steps; ++i) scene.world.step();
        // The ball stops where it touches the bar: 0.35 m from its middle line.
        const DVec2 at = scene.world.state(scene.ball).pose.position;
        CHECK(near((at.x - at.y) / std::sqrt(2.0), 0.35, absolute(0.01)));
    }
}

namespace {

// Full collisions in a second of a shape that slides without friction, 0.9 mm in a step, on a shape that is made before
// or after it. It starts in contact.
std::int64_t collisions_of_slide(const Shape& on, double height, const Shape& sliding, bool is_made_first) {
    WorldDef def;
    def.sleeping = false;
    World world(def);
    const SurfaceMaterial smooth{.friction = 0.0f};
    BodyId body;
    if (is_made_first) body = add_dynamic(world, {0.0, height}, sliding, smooth);
    add_static(world, {}, on, smooth);
    if (!is_made_first) body = add_dynamic(world, {0.0, height}, sliding, smooth);
    run(world, 30);
    world.set_velocity(body, {0.054f, 0.0f}, 0.0f);
    std::int64_t collided = 0;
    for (int i = 0; i < 60; ++i) {
        world.step();
        CHECK(world.contacts().size() == (sliding.vertex_count() == 1 ? 1 : 2));
        collided += world.counters().collided;
    }
    return collided;
}

}  // namespace

TEST_CASE("sharp corners that slide on an edge are collided each 5 mm, other contacts each half millimetre") {
    const Shape floor = make_box({10.0f, 1.0f}), post = make_box({0.4f, 1.0f}), box = make_box({1.0f, 1.0f});
    for (const bool is_made_first : {false, true}) {
        CAPTURE(is_made_first);
        // The first of the 60 collisions is before the first displacement of 0.9 mm.
        CHECK(collisions_of_slide(floor, 1.0, box, is_made_first) == 59 / 6);
        CHECK(collisions_of_slide(post, 1.0, box, is_made_first) == 59 / 6);
        CHECK(collisions_of_slide(floor, 0.54, make_box({0.08f, 0.08f}), is_made_first) == 59 / 3);
        CHECK(collisions_of_slide(floor, 1.0, make_box({1.0f, 1.0f}, 0.1f), is_made_first) == 59);
        CHECK(collisions_of_slide(floor, 1.0, make_circle(0.5f), is_made_first) == 59);
    }
}
