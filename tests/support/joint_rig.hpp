// One body on one joint.
#pragma once

#include "support/worlds.hpp"

namespace tumble::test {

// A box of 2 kg (1 x 2 m) beside a static pivot at the origin.
struct Rig {
    World world;
    BodyId pivot;
    BodyId box;

    explicit Rig(bool gravity, DVec2 position = {}) : world(gravity ? World() : weightless()) {
        pivot = world.create_body({.type = BodyType::static_body});
        box = add_dynamic(world, position, make_box({1.0f, 2.0f}));
    }

    double angle() const { return tumble::angle(world.state(box).pose.rotation); }
    DVec2 position() const { return world.state(box).pose.position; }
};

}  // namespace tumble::test
