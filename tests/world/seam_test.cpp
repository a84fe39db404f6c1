// Floors of several shapes: their seams do not disturb sliding bodies.
#include <doctest/doctest.h>

#include <string>

#include "support/slide.hpp"

using namespace tumble;
using namespace tumble::test;

TEST_CASE("seams of tiles, at rest or moving, neither lift nor rotate nor slow a sliding body") {
    const struct {
        std::string name;
        Shape shape;
        double height;
    } bodies[] = {{"box", make_box({1.2f, 0.5f}), 0.25},
                  {"rounded box", make_box({1.2f, 0.5f}, 0.1f), 0.25},
                  {"ball", make_circle(0.25f), 0.25},
                  {"capsule", make_capsule({-0.3f, 0.0f}, {0.3f, 0.0f}, 0.2f), 0.2}};
    const struct {
        float speed;
        bool tiles_move;
    } slides[] = {
        {2.0f, false}, {10.0f, false}, {25.0f, false}, {1.0f, true}, {24.0f, true}};  // towards tiles of 1 m/s
    for (const auto& body : bodies)
        for (const auto& ride : slides) {
            const float speed = ride.speed;
            World world({.sleeping = false});
            const BodyType type = ride.tiles_move ? BodyType::kinematic_body : BodyType::static_body;
            for (int i = 0; i < 34; ++i) {
                const BodyId tile = add_body(world, type, {i - 5.0, -0.5}, make_box({1.0f, 1.0f}), {.friction = 0.0f});
                if (ride.tiles_move) world.set_velocity(tile, {-1.0f, 0.0f}, 0.0f);
            }
            const int steps = speed < 5.0f ? 200 : 60;  // over 6, 10 and 25 seams
            const Slide found = slide(world, body.shape, {0.0, body.height}, speed, steps);
            INFO(body.name, " at ", speed, ride.tiles_move ? " over moving tiles" : "", ": rise ", found.highest_rise,
                 " speed ", found.fastest_rise, " turn ", found.most_turned, " slowest ", found.slowest);
            CHECK(found.highest_rise < kDeepestSlide);
            CHECK(found.fastest_rise < 1e-3);
            CHECK(found.most_turned < 2e-4);  // that over half its length
            CHECK(found.slowest > 0.9999 * static_cast<double>(speed));
        }
}

// The rise of a ramp and a step is no seam.
TEST_CASE("a ramp or a step above the floor slows a sliding body") {
    for (const bool ramp : {false, true}) {
        CAPTURE(ramp);
        World world({.sleeping = false});
        add_static(world, {0.0, -0.5}, make_box({20.0f, 1.0f}), {.friction = 0.0f});
        const Vec2 wedge[] = {{0.0f, 0.0f}, {4.0f, 0.0f}, {4.0f, 1.0f}};
        add_static(world, {2.0, 0.0}, ramp ? make_polygon(wedge) : make_box({0.1f, 0.02f}), {.friction = 0.0f});
        const Slide found = slide(world, make_box({0.5f, 0.5f}), {0.0, 0.25}, 2.0f, 90);
        CHECK(found.slowest < 1.5);
    }
}
