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
