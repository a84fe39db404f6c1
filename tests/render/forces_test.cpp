// The arrows of contact forces.
#include "render/frame/forces.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "support/near.hpp"
#include "tumble/shape.hpp"

using namespace tumble;
using test::absolute;
using test::near;

namespace {

// A box of 2 kg at rest on a static floor at y = 1, the floor created first or last, under a gravity of 10 m/s^2.
World resting_box(bool floor_first, Vec2 gravity = {0.0f, -10.0f}) {
    WorldDef def;
    def.gravity = gravity;
    World world(def);
    const auto add_floor = [&] {
        BodyDef floor;
        floor.type = BodyType::static_body;
        world.add_shape(world.create_body(floor), {make_box({20.0f, 2.0f}), {}});
    };
    if (floor_first) add_floor();
    BodyDef box;
    box.type = BodyType::dynamic_body;
    box.pose.position = {0.0, 1.5};
    ShapeDef heavy{make_box({1.0f, 1.0f}), {}};
    heavy.material.density = 2.0f;
    world.add_shape(world.create_body(box), heavy);
    if (!floor_first) add_floor();
    for (int i = 0; i < 60; ++i) world.step();
    return world;
}

}  // namespace

TEST_CASE("the arrows of a resting body point upwards, and add up to its weight") {
    for (const bool floor_first : {true, false}) {
        CAPTURE(floor_first);
        const World world = resting_box(floor_first);
        // 20 N: of 1, 2 and 5 times the powers of ten, 20 is the nearest that is not above. A float may be below 20.
        const double unit = render::force_unit(world);
        CHECK((near(unit, 20.0, absolute(1e-9)) || near(unit, 10.0, absolute(1e-9))));
        const render::View view = render::make_view({{0.0, 1.0}, 8.0}, 1280, 720);
        render::Layer layer;
        render::Marks marks(layer, view, {});
        render::add_forces(marks, view, world, {});
        // An arrow is a line, from the contact at row 0, and the two sides of its head: none on the floor.
        REQUIRE(layer.boxes.size() == 6);
        double length = 0.0;
        for (const std::size_t i : {0u, 3u}) {
            const render::BoxInstance& line = layer.boxes[i];
            CHECK(std::abs(line.axis_x) < 1e-3);
            CHECK(near(line.y, line.half_x, absolute(1.0)));  // it begins within a pixel, 1 cm, of the surface
            length += 2.0 * line.half_x;
        }
        // To 1 % of the weight: the box changes its velocity by less than 2 mm/s in a step.
        CHECK(near(length, render::kForceLength * 20.0 / unit, absolute(0.01 * render::kForceLength * 20.0 / unit)));
    }
}

TEST_CASE("the arrows of a body that friction holds add up to the opposite of its weight") {
    for (const bool floor_first : {true, false}) {
        CAPTURE(floor_first);
        // As on a slope: 10 m/s^2, of which 2.8 along the floor, less than the friction of 0.6 holds.
        const World world = resting_box(floor_first, {-2.8f, -9.6f});
        const render::View view = render::make_view({{0.0, 1.0}, 8.0}, 1280, 720);
        render::Layer layer;
        render::Marks marks(layer, view, {});
        render::add_forces(marks, view, world, {});
        REQUIRE(layer.boxes.size() == 6);
        double right = 0.0, up = 0.0;  // pixels
        for (const std::size_t i : {0u, 3u}) {
            const render::BoxInstance& line = layer.boxes[i];
            right += 2.0 * line.half_x * line.axis_x;
            up += 2.0 * line.half_x * line.axis_y;
        }
        const double weight = render::kForceLength * 20.0 / render::force_unit(world);
        CHECK(near(right, 0.28 * weight, absolute(0.01 * weight)));
        CHECK(near(up, 0.96 * weight, absolute(0.01 * weight)));
    }
}

TEST_CASE("a world without dynamic bodies has a unit of force, and an impact an arrow of limited length") {
    CHECK(render::force_unit(World()) > 0.0);
    WorldDef def;
    def.gravity = {0.0f, 0.0f};
    World world(def);
    BodyDef floor;
    floor.type = BodyType::static_body;
    world.add_shape(world.create_body(floor), {make_box({20.0f, 2.0f}), {}});
    BodyDef ball;
    ball.type = BodyType::dynamic_body;
    ball.pose.position = {0.0, 1.51};
    ball.velocity = {0.0f, -50.0f};
    world.add_shape(world.create_body(ball), {make_circle(0.5f), {}});
    const render::View view = render::make_view({{0.0, 1.0}, 8.0}, 1280, 720);
    double longest = 0.0;
    for (int step = 0; step < 3; ++step) {
        world.step();
        render::Layer layer;
        render::Marks marks(layer, view, {});
        render::add_forces(marks, view, world, {});
        for (const render::BoxInstance& line : layer.boxes) longest = std::max(longest, 2.0 * line.half_x);
    }
    CHECK(near(longest, 5.0 * render::kForceLength, absolute(1e-3)));
}
