// Bodies on chains: seams cause no collisions at any speed, and one-sided chains let bodies through from behind.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/near.hpp"
#include "support/slide.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

void add_chain(World& world, const std::vector<Vec2>& points, bool loop, bool one_sided, float friction) {
    BodyDef fixed;
    fixed.type = BodyType::static_body;
    const BodyId ground = world.create_body(fixed);
    const std::vector<Shape> segments = make_chain(points, loop);
    const std::vector<ChainLink> links = make_chain_links(points, loop, one_sided);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        ShapeDef def;
        def.shape = segments[i];
        def.material.friction = friction;
        def.link = links[i];
        world.add_shape(ground, def);
    }
}

struct Start {
    double height;   // m
    float sideways;  // parts of the speed upwards
};

// 100 m of uneven segments along y = 0; from the right to the left, so that the right of them is up.
std::vector<Vec2> flat_points() {
    std::vector<Vec2> points;
    float x = 60.0f;
    for (int i = 0; x > -60.0f; ++i, x -= 0.3f + 0.23f * static_cast<float>(i % 5)) points.push_back({x, 0.0f});
    return points;
}

}  // namespace

TEST_CASE("a body that slides over a flat chain at 50 m/s is not lifted, rotated or slowed by a seam") {
    const struct {
        std::string name;
        Shape shape;
        double height;
    } bodies[] = {{"box", make_box({1.0f, 0.5f}), 0.25},
                  {"rounded box", make_box({1.0f, 0.5f}, 0.1f), 0.25},
                  {"ball", make_circle(0.25f), 0.25},
                  {"capsule", make_capsule({-0.3f, 0.0f}, {0.3f, 0.0f}, 0.2f), 0.2}};
    for (const bool one_sided : {false, true})
        for (const auto& body : bodies) {
            World world;
            add_chain(world, flat_points(), false, one_sided, 0.0f);
            const Slide found = slide(world, body.shape, {-30.0, body.height}, 50.0f, 60);
            INFO(body.name, " rise ", found.highest_rise, " speed ", found.fastest_rise, " turn ", found.most_turned,
                 " slowest ", found.slowest);
            CHECK(found.highest_rise < kDeepestSlide);
            CHECK(found.fastest_rise < 1e-3);
            CHECK(found.most_turned < 2e-4);  // that over half its length
            CHECK(found.slowest > 49.999);
        }
}

TEST_CASE("a ball runs around the inside of a smooth loop and loses no more speed than its bends absorb") {
    // 120 segments, radius 5 m, drawn clockwise: the inside is on their right. A bend by 3 degrees that does not bounce
    // keeps the part cos 3 degrees of the speed; in 5 s the ball rolls over at most 200 of them.
    std::vector<Vec2> points;
    for (int i = 0; i < 120; ++i) {
        const SinCos at = sin_cos(-2.0 * kPi * i / 120);
        points.push_back(to_float({5.0 * at.cos, 5.0 * at.sin}));
    }
    World world = weightless();
    add_chain(world, points, true, true, 0.0f);
    SurfaceMaterial smooth;
    smooth.friction = 0.0f;
    const BodyId ball = add_dynamic(world, {0.0, -4.7}, make_circle(0.25f), smooth);
    world.set_velocity(ball, {10.0f, 0.0f}, 0.0f);
    double farthest = 0.0;
    for (int step = 0; step < 300; ++step) {
        world.step();
        farthest = std::max(farthest, length(world.state(ball).pose.position));
    }
    CHECK(farthest < 4.77);  // 5 m less its radius, sunk in by less than the speculative distance
    CHECK(length(world.state(ball).velocity) > 10.0 * std::pow(std::cos(3.0 * kPi / 180.0), 200));
    CHECK(length(world.state(ball).velocity) < 10.01);
}

TEST_CASE("a one-sided chain stops bodies from its front, and lets them through from behind") {
    for (const float speed : {4.0f, 12.0f, 120.0f}) {  // by contacts, and swept
        World world = weightless();
        add_chain(world, flat_points(), false, true, 0.0f);
        const BodyId up = add_dynamic(world, {0.0, -2.0}, make_box({0.5f, 0.5f}));
        const BodyId down = add_dynamic(world, {5.0, 2.0}, make_box({0.5f, 0.5f}));
        world.set_velocity(up, {0.0f, speed}, 0.0f);
        world.set_velocity(down, {0.0f, -speed}, 0.0f);
        run(world, 90);
        INFO("speed ", speed);
        CHECK(world.state(up).pose.position.y > 3.0);
        CHECK(world.state(down).pose.position.y > 0.2);
    }
}

TEST_CASE("a body from behind crosses a chain without contact, at any speed and phase of the steps") {
    for (const Shape& shape : {make_circle(0.1f), make_circle(0.5f), make_box({0.3f, 0.6f}),
                               make_capsule({-0.4f, 0.0f}, {0.4f, 0.0f}, 0.1f)})
        for (const float speed : {0.5f, 2.9f, 7.3f, 13.0f, 31.0f, 90.0f})
            for (const Start& from : {Start{-1.2, 0.0f}, {-1.25, 1.0f}, {-1.31, -2.0f}, {-1.38, 0.3f}, {-1.3, 4.0f}}) {
                World world = weightless();
                add_chain(world, flat_points(), false, true, 0.5f);
                const BodyId up = add_dynamic(world, {0.13, from.height}, shape, {}, 0.3);
                const Vec2 velocity{from.sideways * speed, speed};
                world.set_velocity(up, velocity, 0.0f);
                INFO("vertices ", shape.vertex_count(), " speed ", speed, " by ", from.sideways, " from ", from.height);
                for (int step = 0; world.state(up).pose.position.y < 1.5; ++step) {
                    REQUIRE(step < 400);
                    world.step();
                    REQUIRE(world.events().contact_begins.empty());
                    REQUIRE(world.contacts().empty());
                }
                CHECK(world.state(up).velocity == velocity);
            }
}

// So slowly that contacts are recycled from step to step, and over the corners of a zigzag.
TEST_CASE("a slow body from behind crosses a bent chain without contact") {
    for (const float height : {0.05f, 0.2f})
        for (const float sideways : {-1.0f, -0.5f, 0.5f, 1.0f})
            for (const double start : {0.13, 0.4, 0.77}) {
                World world = weightless();
                std::vector<Vec2> zigzag;
                for (int i = 0; i < 50; ++i)
                    zigzag.push_back({0.4f * static_cast<float>(25 - i), i % 2 == 0 ? 0.0f : height});
                add_chain(world, zigzag, false, true, 0.5f);
                const BodyId box = add_dynamic(world, {start, -0.45}, make_box({0.3f, 0.8f}));
                world.set_allow_sleep(box, false);
                const float speed = 0.1f * height;  // less than half a millimetre a step
                const Vec2 velocity{sideways * speed, speed};
                world.set_velocity(box, velocity, 0.0f);
                INFO("height ", height, " sideways ", sideways, " start ", start);
                run(world, static_cast<int>(60.0f * 1.2f / speed));
                CHECK(world.state(box).velocity == velocity);
            }
}

// A body that has entered a cup through its bottom hits the walls from their front.
TEST_CASE("a body that crosses one segment is stopped by the next at a right angle") {
    const std::vector<Vec2> cup{{1.0f, 8.0f}, {1.0f, 0.0f}, {-1.0f, 0.0f}, {-1.0f, 8.0f}};
    struct Shot {
        double from;
        Vec2 velocity;
    };
    for (const Shot& shot : {Shot{0.0, {1.0f, 2.0f}}, {0.2, {1.5f, 4.0f}}, {0.4, {1.5f, 8.0f}}}) {
        World world = weightless();
        add_chain(world, cup, false, true, 0.0f);
        const BodyId ball = add_dynamic(world, {shot.from, -1.0}, make_circle(0.4f));
        world.set_velocity(ball, shot.velocity, 0.0f);
        for (int step = 0; step < 90 && world.state(ball).pose.position.y < 7.0; ++step) {
            world.step();
            REQUIRE(world.state(ball).pose.position.x < 0.601);
        }
        CHECK(world.state(ball).pose.position.y > 0.5);
    }
}

TEST_CASE("a body that falls asleep while it crosses a chain continues to cross it after waking") {
    World world = weightless();
    add_chain(world, flat_points(), false, true, 0.5f);
    const BodyId ball = add_dynamic(world, {0.0, -0.6}, make_circle(0.5f));
    world.set_damping(ball, 1.0f, 0.0f);
    world.set_velocity(ball, {0.0f, 0.7f}, 0.0f);  // comes to rest after 0.7 m, or falls asleep before
    run(world, 600);
    REQUIRE_FALSE(world.is_awake(ball));
    const double rest = world.state(ball).pose.position.y;
    REQUIRE(rest > 0.0);
    world.audit();
    world.set_velocity(ball, {0.0f, 0.06f}, 0.0f);
    run(world, 20);
    const double rise = world.state(ball).pose.position.y - rest;  // damped from 0.06 m/s for 1/3 s: 0.017 m
    CHECK(rise > 0.015);
    CHECK(rise < 0.06 / 3.0);
}

TEST_CASE("a body that has crossed a chain lands on it when it comes back") {
    World world;
    add_chain(world, flat_points(), false, true, 0.5f);
    const BodyId ball = add_dynamic(world, {0.0, -1.0}, make_circle(0.25f));
    world.set_velocity(ball, {0.0f, 7.0f}, 0.0f);  // to a height of 1.45 m
    int begins = 0;
    for (int step = 0; step < 180; ++step) {
        world.step();
        begins += static_cast<int>(world.events().contact_begins.size());
    }
    CHECK(begins >= 1);
    CHECK(near(world.state(ball).pose.position.y, 0.25, absolute(kRestingDepth)));
}
