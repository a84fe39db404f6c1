// One world of everything, against hashes written down here: each build of the project is compared with every other, by
// compiler, optimisation and instruction set.
//
// Whoever changes what the step computes writes the new hashes down, from any build; that all builds agree on them is
// what the test is about.
#include <doctest/doctest.h>

#include <cstdint>
#include <random>

#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

struct Draw {
    std::mt19937 random{2026};

    // In [0, 1): from the generator's integers, as distributions differ between standard libraries.
    float next() { return static_cast<float>(random() >> 8) * 0x1p-24f; }
    float between(float low, float high) { return low + (high - low) * next(); }
};

Shape draw_shape(Draw& draw, int kind) {
    const float size = draw.between(0.2f, 0.5f);
    switch (kind) {
        case 0:
            return make_circle(size);
        case 1:
            return make_box({2.0f * size, size}, 0.1f * size);
        case 2:
            return make_capsule({-size, 0.0f}, {size, 0.1f}, 0.15f);
        default: {
            const Vec2 corners[] = {{-size, -size},
                                    {size, -0.5f * size},
                                    {1.1f * size, 0.4f * size},
                                    {0.2f * size, size},
                                    {-size, 0.3f * size}};
            return make_polygon(corners);
        }
    }
}

// Far from the origin: a bowl with a belt, bodies of every shape and surface, chains of them in joints, a spinner.
World make_everything() {
    Draw draw;
    World world;
    const DVec2 far{700.0, -300.0};
    add_static(world, far, make_box({12.0f, 1.0f}), {.tangent_speed = 1.0f}, 0.1);
    add_static(world, far + DVec2{-8.0, 3.0}, make_capsule({0.0f, 0.0f}, {2.0f, -3.0f}, 0.3f), {.friction = 0.1f});
    add_static(world, far + DVec2{8.0, 3.0}, make_segment({0.0f, 0.0f}, {-2.0f, -3.0f}));
    const BodyId spinner =
        add_body(world, BodyType::kinematic_body, far + DVec2{0.0, 2.5}, make_box({5.0f, 0.3f}), {.friction = 1.0f});
    world.set_velocity(spinner, {}, 1.5f);
    BodyId before{};
    for (int i = 0; i < 80; ++i) {
        const Shape shape = draw_shape(draw, i % 4);
        SurfaceMaterial surface;
        surface.density = draw.between(0.5f, 4.0f);
        surface.friction = draw.next();
        surface.restitution = 0.5f * draw.next();
        surface.rolling_resistance = 0.1f * draw.next();
        const double turn = static_cast<double>(draw.between(-3.0f, 3.0f));
        const BodyId body = add_dynamic(world, far + DVec2{-4.5 + i % 10, 5.0 + i / 10}, shape, surface, turn);
        if (i % 10 >= 7)
            world.create_joint(RevoluteJointDef{
                .body_a = before, .body_b = body, .anchor_a = {0.5f, 0.0f}, .anchor_b = {-0.5f, 0.1f}});
        if (i % 10 == 3) world.create_joint(DistanceJointDef{.body_a = before, .body_b = body, .length = 0.9f});
        before = body;
    }
    return world;
}

}  // namespace

TEST_CASE("every build computes the same bits") {
    World world = make_everything();
    run(world, 60);
    CHECK(world.state_hash() == 6359801618272208055u);
    run(world, 540);
    CHECK(world.state_hash() == 5266408762480814949u);
    CHECK(world.counters().contacts > 20);
}
