// Elastic discs in a world whose impacts happen in the order of time.
#pragma once

#include "support/worlds.hpp"

namespace tumble::test {

inline constexpr SurfaceMaterial kElastic{.friction = 0.0f, .restitution = 1.0f};

inline World ordered(Vec2 gravity = {}) {
    WorldDef def;
    def.gravity = gravity;
    def.sleeping = false;
    def.impacts = ImpactModel::in_order;
    return World(def);
}

inline BodyId throw_disc(World& world, DVec2 from, Vec2 velocity, const SurfaceMaterial& material,
                         float radius = 0.5f) {
    const BodyId disc = add_dynamic(world, from, make_circle(radius), material);
    world.set_velocity(disc, velocity, 0.0f);
    return disc;
}

inline double kinetic_energy(const World& world) {
    double energy = 0.0;
    for (const BodyId id : world.bodies()) {
        const Vec2 velocity = world.state(id).velocity;
        energy += 0.5 * static_cast<double>(world.mass(id).mass * length_sq(velocity));
    }
    return energy;
}

// Four walls around a square of a side `size` about the origin.
inline void add_walls(World& world, float size, const SurfaceMaterial& material) {
    const double middle = 0.5 * static_cast<double>(size) + 0.5;
    for (const double side : {-1.0, 1.0}) {
        add_static(world, {side * middle, 0.0}, make_box({1.0f, size + 2.0f}), material);
        add_static(world, {0.0, side * middle}, make_box({size + 2.0f, 1.0f}), material);
    }
}

}  // namespace tumble::test
