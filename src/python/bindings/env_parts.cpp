#include "python/bindings/env_parts.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::python {

namespace {

// splitmix64 (Steele, Lea, Flood 2014).
std::uint64_t scramble(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// The point with the component along a unit axis replaced.
DVec2 with_component(DVec2 point, Vec2 axis, double value) {
    const DVec2 direction(axis);
    return point + (value - dot(point, direction)) * direction;
}

void set_velocity(World& world, const ActionPlan& plan, float value) {
    const BodyState state = world.state(plan.body);
    const DVec2 velocity = with_component(DVec2(state.velocity), plan.axis, double{value});
    world.set_velocity(plan.body, to_float(velocity), state.angular_velocity);
}

void set_target(World& world, const ActionPlan& plan, float value) {
    const DVec2 from(plan.point);
    const DVec2 now = world.joint_anchors(plan.joint)->a - from;
    world.set_target(plan.joint, from + with_component(now, plan.axis, double{value}));
}

void push(World& world, const ActionPlan& plan, float value) {
    const Pose pose = world.state(plan.body).pose;
    world.apply_force(plan.body, value * rotate(pose.rotation, plan.axis), transform_point(pose, plan.point));
}

double free_part(const World& world, const ObservedPlan& plan) {
    const Pose pose = world.state(plan.body).pose;
    const Vec2 direction = plan.turns ? rotate(pose.rotation, plan.axis) : plan.axis;
    QueryFilter filter;
    filter.except = plan.body;
    filter.shape.mask = plan.mask;
    const auto hit = world.cast_ray(transform_point(pose, plan.point), DVec2(direction), filter);
    return hit ? hit->fraction : 1.0;
}

// The sum of the impulses between a body and another, or all others, in the last step, N s.
double normal_impulse(const std::vector<ContactPoint>& contacts, BodyId body, BodyId other) {
    const auto is_other = [&](BodyId id) { return other == BodyId{} || id == other; };
    double sum = 0.0;
    for (const ContactPoint& contact : contacts)
        if ((contact.body_a == body && is_other(contact.body_b)) ||
            (contact.body_b == body && is_other(contact.body_a)))
            sum += double{contact.normal_impulse};
    return sum;
}

void move(World& world, BodyId body, DVec2 by, double turn) {
    const Pose pose = world.state(body).pose;
    world.set_transform(body, {pose.position + by, make_rotation(angle(pose.rotation) + turn)});
}

void scale_mass(World& world, BodyId body, float factor) {
    BodyMass mass = world.mass(body);
    mass.mass *= factor;
    mass.inertia *= factor;
    world.set_mass(body, mass);
}

void scale_material(World& world, BodyId body, float SurfaceMaterial::*member, float factor) {
    for (const ShapeId shape : world.shapes(body)) {
        SurfaceMaterial material = world.material(shape);
        material.*member *= factor;
        world.set_material(shape, material);
    }
}

}  // namespace

std::uint64_t random_whole(std::uint64_t seed, std::uint64_t world, std::uint64_t episode, std::uint64_t draw) {
    return scramble(scramble(scramble(scramble(seed) ^ world) ^ episode) ^ draw) >> 11;
}

double uniform(std::uint64_t seed, std::uint64_t world, std::uint64_t episode, std::uint64_t draw) {
    return static_cast<double>(random_whole(seed, world, episode, draw)) * 0x1p-53;
}

void randomize(World& world, const RandomPlan& plan, float value) {
    const BodyState state = world.state(plan.body);
    const auto add_velocity = [&](Vec2 by, float turn) {
        world.set_velocity(plan.body, state.velocity + by, state.angular_velocity + turn);
    };
    switch (plan.kind) {
        case RandomKind::x: return move(world, plan.body, {double{value}, 0.0}, 0.0);
        case RandomKind::y: return move(world, plan.body, {0.0, double{value}}, 0.0);
        case RandomKind::angle: return move(world, plan.body, {}, double{value});
        case RandomKind::velocity_x: return add_velocity({value, 0.0f}, 0.0f);
        case RandomKind::velocity_y: return add_velocity({0.0f, value}, 0.0f);
        case RandomKind::angular_velocity: return add_velocity({}, value);
        case RandomKind::gravity_scale:
            return world.set_gravity_scale(plan.body, world.definition(plan.body).gravity_scale + value);
        case RandomKind::impulse_x: return world.apply_impulse(plan.body, {value, 0.0f});
        case RandomKind::impulse_y: return world.apply_impulse(plan.body, {0.0f, value});
        case RandomKind::mass: return scale_mass(world, plan.body, value);
        case RandomKind::friction: return scale_material(world, plan.body, &SurfaceMaterial::friction, value);
        case RandomKind::restitution: return scale_material(world, plan.body, &SurfaceMaterial::restitution, value);
    }
}

float action_value(const ActionPlan& plan, float entry) {
    const float part = 0.5f * (std::clamp(entry, -1.0f, 1.0f) + 1.0f);
    return plan.low + part * (plan.high - plan.low);
}

void act(World& world, const ActionPlan& plan, float value) {
    switch (plan.kind) {
        case ActionKind::force: return world.apply_force(plan.body, value * plan.axis);
        case ActionKind::thrust: return push(world, plan, value);
        case ActionKind::torque: return world.apply_torque(plan.body, value);
        case ActionKind::motor_speed: return world.set_motor_speed(plan.joint, value);
        case ActionKind::motor_effort:
            return world.set_motor(plan.joint, value < 0.0f ? -plan.speed : plan.speed, std::abs(value));
        case ActionKind::velocity: return set_velocity(world, plan, value);
        case ActionKind::spin: return world.set_velocity(plan.body, world.state(plan.body).velocity, value);
        case ActionKind::target: return set_target(world, plan, value);
    }
}

double measure(const World& world, const std::vector<ContactPoint>& contacts, const ObservedPlan& plan) {
    switch (plan.kind) {
        case ObservedKind::x: return world.state(plan.body).pose.position.x;
        case ObservedKind::y: return world.state(plan.body).pose.position.y;
        case ObservedKind::angle: return angle(world.state(plan.body).pose.rotation);
        case ObservedKind::velocity_x: return double{world.state(plan.body).velocity.x};
        case ObservedKind::velocity_y: return double{world.state(plan.body).velocity.y};
        case ObservedKind::angular_velocity: return double{world.state(plan.body).angular_velocity};
        case ObservedKind::joint_position: return world.joint_motion(plan.joint).position;
        case ObservedKind::joint_speed: return world.joint_motion(plan.joint).speed;
        case ObservedKind::touching: return normal_impulse(contacts, plan.body, plan.other) > 0.0 ? 1.0 : 0.0;
        case ObservedKind::contact_force:
            return normal_impulse(contacts, plan.body, plan.other) * double{world.def().steps_per_second};
        case ObservedKind::ray: return free_part(world, plan);
        case ObservedKind::value: break;
    }
    return 0.0;
}

}  // namespace tumble::python
