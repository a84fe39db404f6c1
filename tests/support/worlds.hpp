// Short functions that put things into a world, for tests.
#pragma once

#include <cmath>

#include "tumble/world.hpp"

namespace tumble::test {

inline constexpr float kStep = 1.0f / 60.0f;

// How deep a body of any shape rests in a static one, or hangs below its joint, at most, under a gravity of 10 m/s^2.
// Soft contacts of 42.6 Hz yield by 1.25 g / (4 w^2) = 0.044 mm under two points, w = 2 pi 42.6 rad/s, joints of 60 Hz
// by g / w^2 = 0.070 mm.
inline constexpr double kRestingDepth = 1e-4;  // m

inline BodyId add_body(World& world, BodyType type, DVec2 position, const Shape& shape,
                       const SurfaceMaterial& material = {}, double angle = 0.0) {
    BodyDef def;
    def.type = type;
    def.pose = {position, make_rotation(angle)};
    const BodyId id = world.create_body(def);
    world.add_shape(id, {shape, material});
    return id;
}

inline BodyId add_dynamic(World& world, DVec2 position, const Shape& shape, const SurfaceMaterial& material = {},
                          double angle = 0.0) {
    return add_body(world, BodyType::dynamic_body, position, shape, material, angle);
}

inline BodyId add_static(World& world, DVec2 position, const Shape& shape, const SurfaceMaterial& material = {},
                         double angle = 0.0) {
    return add_body(world, BodyType::static_body, position, shape, material, angle);
}

// A floor of 200 m whose top is y = 0.
inline BodyId add_floor(World& world, const SurfaceMaterial& material = {}) {
    return add_static(world, {0.0, -1.0}, make_box({200.0f, 2.0f}), material);
}

inline bool touches(const World& world, BodyId a, BodyId b) {
    for (const ContactPoint& point : world.contacts())
        if ((point.body_a == a && point.body_b == b) || (point.body_a == b && point.body_b == a)) return true;
    return false;
}

inline void run(World& world, int steps) {
    for (int i = 0; i < steps; ++i) world.step();
}

inline World weightless() {
    WorldDef def;
    def.gravity = {0.0f, 0.0f};
    return World(def);
}

// Rows of unit boxes, the lowest `base` wide, on a floor.
inline void add_pyramid(World& world, int base) {
    add_floor(world);
    for (int row = 0; row < base; ++row)
        for (int column = row; column < base; ++column)
            add_dynamic(world, {0.5 * (row + 1) + (column - row) - 0.5 * base, row + 0.5}, make_box({1.0f, 1.0f}));
}

}  // namespace tumble::test
