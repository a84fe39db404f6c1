// Two geared wheels, for tests.
#pragma once

#include "support/worlds.hpp"

namespace tumble::test {

// Two wheels of radii 1 and 2 m, hinged to a frame, and a gear on the hinges: I = 2 and 32 kg m^2 for a density of 4 /
// pi.
struct Wheels {
    World world;
    BodyId frame, a, b;
    JointId hinge_a, hinge_b, gear;

    Wheels(World empty, BodyType frame_type, float ratio) : world(std::move(empty)) {
        const SurfaceMaterial surface{.density = 4.0f / static_cast<float>(kPi)};
        frame = add_body(world, frame_type, {}, make_box({4.0f, 0.5f}));
        a = add_dynamic(world, {-1.5, 0.0}, make_circle(1.0f), surface);
        b = add_dynamic(world, {1.5, 0.0}, make_circle(2.0f), surface);
        hinge_a = world.create_joint(RevoluteJointDef{.body_a = frame, .body_b = a, .anchor_a = {-1.5f, 0.0f}});
        hinge_b = world.create_joint(RevoluteJointDef{.body_a = frame, .body_b = b, .anchor_a = {1.5f, 0.0f}});
        gear = world.create_joint(GearJointDef{.joint_a = hinge_a, .joint_b = hinge_b, .ratio = ratio});
    }

    double speed(BodyId body) const { return double{world.state(body).angular_velocity}; }
    double turned(BodyId body) const { return angle(world.state(body).pose.rotation); }
};

}  // namespace tumble::test
