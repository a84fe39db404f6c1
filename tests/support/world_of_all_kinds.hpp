// A world with one of everything that a snapshot can contain: rolling resistance, bounces, a large polygon, an island
// that sleeps, a one-sided chain that a ball crosses, a sensor, bullets, a kinematic body, locks, and every kind of
// joint.
#pragma once

#include <vector>

#include "support/worlds.hpp"
#include "tumble/chain.hpp"
#include "tumble/shape.hpp"

namespace tumble::test {

inline void add_rolling_things(World& world) {
    const SurfaceMaterial rough{1.0f, 0.8f, 0.0f, 0.05f, 0.0f}, bouncy{2.0f, 0.3f, 0.7f, 0.0f, 0.5f};
    add_static(world, {0.0, -1.0}, make_box({200.0f, 2.0f}), rough);
    for (int i = 0; i < 3; ++i) {
        const BodyId ball = add_dynamic(world, {-20.0 + 2.0 * i, 0.5}, make_circle(0.5f), rough);
        world.set_velocity(ball, {1.0f + static_cast<float>(i), 0.0f}, -2.0f);
    }
    add_dynamic(world, {-12.0, 2.2}, make_box({0.8f, 0.6f}, 0.05f), bouncy, 0.3);
    std::vector<Vec2> points;
    for (int i = 0; i < 20; ++i) {
        const Rotation turn = make_rotation(0.1 * kPi * i);
        points.push_back({0.6f * turn.c, 0.4f * turn.s});
    }
    const BodyId large = add_dynamic(world, {-9.0, 0.6}, make_polygon(points), rough, 0.2);
    world.apply_impulse(large, {0.5f, 0.0f});
}

// Two stacks, of which one is put to sleep.
inline void add_stacks(World& world) {
    BodyId top{};
    for (int stack = 0; stack < 2; ++stack)
        for (int i = 0; i < 3; ++i) {
            top = add_dynamic(world, {-5.0 + 2.0 * stack, 0.5 + i}, make_box({1.0f, 1.0f}), {}, 0.0);
            world.set_damping(top, 0.1f, 0.2f);
        }
    run(world, 20);
    world.set_awake(top, false);
}

// One ball crosses the chain from below, one rests on it.
inline void add_one_sided_chain(World& world) {
    BodyDef fixed;
    fixed.type = BodyType::static_body;
    fixed.pose.position = {4.0, 1.0};
    const BodyId ground = world.create_body(fixed);
    const std::vector<Vec2> points{{2.0f, 0.3f}, {1.0f, 0.0f}, {0.0f, 0.0f}, {-1.0f, 0.0f}, {-2.0f, 0.3f}};
    const std::vector<Shape> segments = make_chain(points, false);
    const std::vector<ChainLink> links = make_chain_links(points, false, true);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        ShapeDef def;
        def.shape = segments[i];
        def.link = links[i];
        world.add_shape(ground, def);
    }
    add_dynamic(world, {3.2, 1.4}, make_circle(0.3f));
    const BodyId riser = add_dynamic(world, {4.6, 0.4}, make_circle(0.3f));
    world.set_gravity_scale(riser, -0.06f);
    world.set_velocity(riser, {0.1f, 0.9f}, 0.0f);
}

// A sensor with a box inside, a kinematic lift, and a locked body.
inline void add_special_bodies(World& world) {
    const BodyId post = add_static(world, {10.0, 0.5}, make_box({0.1f, 0.1f}));
    ShapeDef sensor;
    sensor.shape = make_box({2.0f, 2.0f});
    sensor.sensor = true;
    world.add_shape(post, sensor);
    add_dynamic(world, {10.5, 1.0}, make_box({0.4f, 0.4f}));
    const BodyId lift = add_body(world, BodyType::kinematic_body, {15.0, 1.0}, make_box({1.0f, 0.2f}));
    world.set_velocity(lift, {0.0f, 0.3f}, 0.1f);
    const BodyId rider = add_dynamic(world, {15.0, 1.4}, make_box({0.5f, 0.5f}));
    world.set_locks(rider, {true, false, true});
    BodyDef heavy;
    heavy.pose.position = {17.0, 3.0};
    heavy.mass = BodyMass{3.0f, {0.1f, 0.0f}, 0.5f};
    world.add_shape(world.create_body(heavy), {make_capsule({-0.3f, 0.0f}, {0.3f, 0.0f}, 0.2f)});
}

template <class Def>
Def between(World& world, double x, Def def) {
    def.body_a = add_dynamic(world, {x, 6.0}, make_box({0.6f, 0.3f}));
    def.body_b = add_dynamic(world, {x + 0.5, 6.1}, make_box({0.6f, 0.3f}), {}, 0.1);
    if constexpr (requires { def.anchor_a; }) {
        def.anchor_a = {0.35f, 0.05f};
        def.anchor_b = {-0.35f, 0.0f};
    }
    return def;
}

inline void add_joints(World& world) {
    const JointSpring spring{3.0f, 0.3f};
    RevoluteJointDef hinge;
    hinge.limits = JointLimits{-0.1f, 0.2f};
    hinge.motor = AngularMotor{2.0f, 1.0f};
    hinge.spring = spring;
    hinge.break_force = 4000.0f;
    const JointId hinge_id = world.create_joint(between(world, 20.0, hinge));
    PrismaticJointDef slider;
    slider.limits = JointLimits{-0.1f, 0.1f};
    slider.motor = LinearMotor{-2.0f, 50.0f};
    slider.spring = spring;
    slider.break_torque = 4000.0f;
    const JointId slider_id = world.create_joint(between(world, 23.0, slider));
    GearJointDef gear;
    gear.joint_a = hinge_id;
    gear.joint_b = slider_id;
    gear.ratio = 0.5f;
    world.create_joint(gear);
    world.create_joint(
        between(world, 26.0, DistanceJointDef{.length = 0.2f, .limits = JointLimits{0.05f, 0.3f}, .spring = spring}));
    world.create_joint(between(world, 29.0, WeldJointDef{.linear_spring = spring, .angular_spring = spring}));
    world.create_joint(between(world, 32.0, WeldJointDef{}));
    world.create_joint(between(
        world, 35.0,
        WheelJointDef{.limits = JointLimits{-0.05f, 0.05f}, .motor = AngularMotor{3.0f, 1.0f}, .spring = spring}));
    world.create_joint(between(
        world, 38.0,
        MotorJointDef{.velocity = {0.1f, 0.2f}, .angular_velocity = 0.3f, .max_force = 20.0f, .max_torque = 3.0f}));
    world.create_joint(between(world, 41.0, MouseJointDef{.max_force = 30.0f}));
    world.create_joint(between(world, 44.0, FilterJointDef{}));
    PulleyJointDef pulley = between(world, 47.0, PulleyJointDef{.length = 3.0f, .ratio = 1.5f});
    pulley.ground_anchor_a = {47.0, 8.0};
    pulley.ground_anchor_b = {48.0, 7.0};
    world.create_joint(pulley);
}

// Bullets that fly towards a thin wall, a ball about to bounce, one about to cross the chain, and a filter that was
// just changed.
inline void add_last_things(World& world) {
    add_static(world, {14.0, 5.0}, make_box({0.02f, 4.0f}));
    for (int i = 0; i < 3; ++i) {
        BodyDef bullet;
        bullet.bullet = i != 1;
        bullet.allow_fast_rotation = true;
        bullet.pose.position = {10.0, 4.0 + 0.7 * i};
        bullet.velocity = {60.0f + 40.0f * static_cast<float>(i), -2.0f};
        bullet.angular_velocity = 30.0f;
        world.add_shape(world.create_body(bullet), {make_capsule({-0.2f, 0.0f}, {0.1f, 0.0f}, 0.05f)});
    }
    const BodyId bouncer = add_dynamic(world, {-26.0, 0.41}, make_circle(0.3f), {.restitution = 0.7f});
    world.set_velocity(bouncer, {0.0f, -4.0f}, 0.0f);
    const BodyId riser = add_dynamic(world, {4.4, 0.75}, make_circle(0.3f));
    world.set_velocity(riser, {0.1f, 3.0f}, 0.0f);
    world.step();
    CollisionFilter filter;
    filter.mask = 2;
    for (const ShapeId shape : world.shapes(riser)) world.set_filter(shape, {});
    for (const ShapeId shape : world.shapes(world.bodies()[1])) world.set_filter(shape, filter);
}

// All kinds of things in motion, after 41 steps.
inline World make_world_of_all_kinds(const WorldDef& def = {}) {
    World world(def);
    add_rolling_things(world);
    add_stacks(world);
    add_one_sided_chain(world);
    add_special_bodies(world);
    add_joints(world);
    run(world, 40);
    add_last_things(world);
    return world;
}

}  // namespace tumble::test
