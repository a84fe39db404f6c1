// Equal calls give equal bits: in two worlds of one process, and in every build of the project.
#include <doctest/doctest.h>

#include <cstdint>
#include <random>

#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

World make_pyramid() {
    World world;
    add_pyramid(world, 12);
    return world;
}

// Everything at once: shapes of all kinds, restitution, rolling resistance, a belt, far from the origin.
World make_heap() {
    World world;
    const DVec2 far{3000.0, -2000.0};
    add_static(world, far, make_box({40.0f, 2.0f}), {.tangent_speed = 0.5f}, 0.05);
    std::mt19937 random(11);
    for (int i = 0; i < 60; ++i) {
        const DVec2 position = far + DVec2{-4.0 + i % 9, 2.0 + i / 9};
        const auto size = 0.2f + 0.001f * static_cast<float>(random() % 300);
        const SurfaceMaterial material{.restitution = 0.4f, .rolling_resistance = 0.05f};
        const Vec2 corners[] = {{-size, -size}, {size, -0.5f * size}, {0.2f * size, size}, {-size, 0.3f * size}};
        switch (i % 3) {
            case 0: add_dynamic(world, position, make_circle(size), material, i); break;
            case 1: add_dynamic(world, position, make_polygon(corners), material, i); break;
            default: add_dynamic(world, position, make_capsule({-size, 0.0f}, {size, 0.0f}, 0.1f), material, i);
        }
    }
    return world;
}

}  // namespace

TEST_CASE("two runs of a scene have the same hash in every step") {
    World first = make_heap(), second = make_heap();
    for (int step = 0; step < 200; ++step) {
        first.step();
        second.step();
        REQUIRE(first.state_hash() == second.state_hash());
    }
}

TEST_CASE("the hash depends on the last bit of one body") {
    World first = make_pyramid(), second = make_pyramid();
    CHECK(first.state_hash() == second.state_hash());
    const BodyId body = second.bodies().back();
    second.set_velocity(body, {0x1p-149f, 0.0f}, 0.0f);
    CHECK(first.state_hash() != second.state_hash());
}
