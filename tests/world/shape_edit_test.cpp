// Changes of shapes between steps: surfaces, filters, removal.
#include <doctest/doctest.h>

#include <cmath>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

const Shape kBox = make_box({1.0f, 1.0f});

}  // namespace

TEST_CASE("a new material under a body acts at once: it slides on ice, and stays on rubber") {
    World world;
    const BodyId ramp = add_static(world, {0.0, 0.0}, make_box({40.0f, 1.0f}), {.friction = 1.0f}, 0.3);
    const Rotation tilt = make_rotation(0.3);
    const DVec2 on_top = rotate(tilt, DVec2{0.0, 1.0});
    const BodyId box = add_dynamic(world, on_top, kBox, {.friction = 1.0f}, 0.3);
    run(world, 90);
    const DVec2 position = world.state(box).pose.position;
    REQUIRE(length(position - on_top) < 0.01);
    world.set_material(world.shapes(ramp)[0], {.friction = 0.0f});
    CHECK(world.is_awake(box));
    run(world, 60);
    // g sin(0.3) for a second.
    CHECK(near(length(world.state(box).velocity), 10.0 * std::sin(0.3), float_sum(240)));
    world.set_material(world.shapes(box)[0], {.density = 4.0f});
    CHECK(world.mass(box).mass == 4.0f);
}

TEST_CASE("a change of filters ends and begins contacts") {
    World world;
    const BodyId floor = add_floor(world);
    const BodyId box = add_dynamic(world, {0.0, 0.5}, kBox);
    run(world, 90);
    REQUIRE_FALSE(world.is_awake(box));
    world.set_filter(world.shapes(box)[0], {.mask = 0});
    world.step();
    CHECK(world.events().contact_ends.size() == 1);
    CHECK_FALSE(touches(world, floor, box));
    run(world, 10);
    CHECK(world.state(box).pose.position.y < 0.4);
    world.set_filter(world.shapes(box)[0], {});
    world.step();
    CHECK(world.events().contact_begins.size() == 1);
    run(world, 200);
    CHECK(near(world.state(box).pose.position.y, 0.5, absolute(kRestingDepth)));
}

TEST_CASE("a removed shape has neither mass nor contacts, and the rest of the body keeps its motion") {
    World world = weightless();
    const BodyId body = add_dynamic(world, {0.0, 0.0}, kBox);
    const ShapeId arm = world.add_shape(body, {make_box({1.0f, 1.0f}, 0.0f, {2.0f, 0.0f})});
    world.set_velocity(body, {1.0f, 0.0f}, 2.0f);
    CHECK(world.mass(body).center.x == 1.0f);
    world.remove_shape(arm);
    CHECK_FALSE(world.is_valid(arm));
    CHECK(world.shapes(body).size() == 1);
    CHECK(world.mass(body).mass == 1.0f);
    // The new centre is 1 m to the left of the old one: v = v0 + w x (-1, 0).
    CHECK(world.state(body).velocity == Vec2{1.0f, -2.0f});
    world.step();
    world.audit();
}
