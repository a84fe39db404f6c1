// Worlds of random bodies, shapes and joints that are edited at random between their steps: everything that the public
// interface allows, in any order. One seed, one world, on every machine.
#pragma once

#include <algorithm>
#include <optional>
#include <random>
#include <vector>

#include "support/worlds.hpp"

namespace tumble::test {

class RandomWorld {
public:
    // The floor stays: as a body it would be a lever of 100 m.
    explicit RandomWorld(std::uint32_t seed) : random_(seed), world(draw_def()) {
        add_floor(world);
        const int bodies = integer(5, 30), joints = integer(0, 12);
        for (int i = 0; i < bodies; ++i) add_body();
        for (int i = 0; i < joints; ++i) add_joint();
    }

    // The same random numbers from here on, for another world in the same state.
    RandomWorld(const RandomWorld& other, World state) : random_(other.random_), world(std::move(state)) {}

    void edit() {
        make_edit();
        // No joint can slow the spin of a body without inertia (BodyMass): it would be a motor of unlimited torque.
        for (const BodyId id : world.bodies())
            if (world.type(id) == BodyType::dynamic_body && world.is_enabled(id) && world.mass(id).inertia == 0.0f &&
                world.state(id).angular_velocity != 0.0f)
                world.set_velocity(id, world.state(id).velocity, 0.0f);
    }

private:
    void make_edit() {
        switch (integer(0, 21)) {
            case 0: return add_body();
            case 1:
                if (const auto id = pick(world.bodies().subspan(1))) world.destroy_body(*id);
                return;
            case 2: return add_joint();
            case 3:
                if (const auto id = pick(world.joints())) world.destroy_joint(*id);
                return;
            case 4:
                if (const auto id = pick(world.bodies())) world.set_transform(*id, draw_move(*id));
                return;
            case 5:
                if (const auto id = pick(world.bodies().subspan(1))) world.set_type(*id, draw_type());
                return;
            case 6:
                if (const auto id = pick(world.bodies())) world.set_enabled(*id, !world.is_enabled(*id));
                return;
            case 7:
                if (const auto id = pick(world.bodies())) world.set_locks(*id, draw_locks());
                return;
            case 8:
                if (const auto id = pick(world.bodies())) world.set_mass(*id, draw_mass());
                return;
            case 9:
                if (const auto id = pick(world.bodies())) world.set_awake(*id, coin());
                return;
            case 10:
                if (const auto id = pick(world.bodies())) world.set_bullet(*id, coin());
                return;
            case 11:
                if (const auto id = pick(world.bodies())) world.set_gravity_scale(*id, between(-1.0f, 2.0f));
                return;
            case 12:
                if (const auto id = pick(world.bodies())) world.set_allow_sleep(*id, coin());
                return;
            case 13: return set_velocity();
            case 14: return push();
            case 15:
                if (const auto id = pick(world.bodies())) world.add_shape(*id, draw_shape_def());
                return;
            case 16:
                if (const auto id = pick_shape()) world.remove_shape(*id);
                return;
            case 17:
                if (const auto id = pick_shape()) world.set_material(*id, draw_material());
                return;
            case 18:
                if (const auto id = pick_shape()) world.set_filter(*id, draw_filter());
                return;
            case 19: return redefine_joint();
            case 20:
                if (const auto id = pick(world.bodies())) world.set_damping(*id, unit(), unit());
                return;
            default: return world.set_gravity({between(-3.0f, 3.0f), between(-10.0f, 2.0f)});
        }
    }

    std::mt19937 random_;  // before the world, which is drawn from it

public:
    World world;

private:
    int integer(int low, int high) { return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1)); }
    float unit() { return static_cast<float>(random_() >> 8) * 0x1p-24f; }  // [0, 1)
    float between(float low, float high) { return low + (high - low) * unit(); }
    bool coin() { return (random_() & 1u) != 0; }

    template <class IdType>
    std::optional<IdType> pick(std::span<const IdType> ids) {
        if (ids.empty()) return std::nullopt;
        return ids[random_() % ids.size()];
    }

    std::optional<ShapeId> pick_shape() {
        const auto body = pick(world.bodies());
        return body ? pick(world.shapes(*body)) : std::nullopt;
    }

    // Not far from where it is: joints pull it back.
    Pose draw_move(BodyId id) {
        const double x = between(-0.5f, 0.5f);
        const double y = between(-0.5f, 0.5f);
        const Pose pose = world.state(id).pose;
        return {pose.position + DVec2{x, y}, make_rotation(angle(pose.rotation) + between(-0.5f, 0.5f))};
    }

    WorldDef draw_def() {
        WorldDef def;
        def.substeps = integer(1, 6);
        def.sleeping = integer(0, 3) > 0;
        def.continuous = integer(0, 3) > 0;
        def.impacts = coin() ? ImpactModel::in_order : ImpactModel::at_step_end;
        def.joints = integer(0, 3) > 0 ? JointSolver::iterative : JointSolver::direct;
        return def;
    }

    BodyType draw_type() {
        const int kind = integer(0, 9);
        return kind == 0 ? BodyType::static_body : kind == 1 ? BodyType::kinematic_body : BodyType::dynamic_body;
    }

    Pose draw_pose() {
        const double x = between(-6.0f, 6.0f);
        const double y = between(0.0f, 10.0f);
        return {{x, y}, make_rotation(between(-3.0f, 3.0f))};
    }

    BodyLocks draw_locks() {
        const int bits = integer(0, 15);  // half of all without one
        return bits < 8 ? BodyLocks{} : BodyLocks{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
    }

    std::optional<BodyMass> draw_mass() {
        if (coin()) return std::nullopt;
        const float mass = between(0.1f, 20.0f);
        const float x = between(-0.2f, 0.2f);
        return BodyMass{mass, {x, 0.0f}, coin() ? 0.0f : mass * between(0.05f, 1.0f)};
    }

    SurfaceMaterial draw_material() {
        SurfaceMaterial material;
        material.density = between(0.2f, 5.0f);
        material.friction = unit();
        if (integer(0, 2) == 0) material.restitution = unit();
        if (integer(0, 3) == 0) material.rolling_resistance = 0.2f * unit();
        if (integer(0, 5) == 0) material.tangent_speed = between(-2.0f, 2.0f);
        return material;
    }

    CollisionFilter draw_filter() {
        CollisionFilter filter;
        if (coin()) return filter;
        filter.category = 1u << integer(0, 2);
        filter.mask = static_cast<std::uint64_t>(integer(1, 7));
        filter.group = integer(-1, 1);
        return filter;
    }

    Shape draw_shape() {
        const float size = between(0.05f, 0.8f);
        const float other = between(0.3f, 1.0f) * size;
        switch (integer(0, 5)) {
            case 0: return make_circle(size);
            case 1: return make_box({2.0f * size, 2.0f * other});
            case 2: return make_box({2.0f * size, 2.0f * other}, 0.2f * other);
            case 3: return make_capsule({-size, 0.0f}, {size, 0.1f}, 0.5f * other);
            case 4: return make_segment({-size, 0.0f}, {size, other});
            default: return draw_polygon(size);
        }
    }

    Shape draw_polygon(float size) {
        std::vector<Vec2> points;
        const int count = integer(3, 14);
        for (int i = 0; i < count; ++i) {
            const float x = between(-size, size);
            points.push_back({x, between(-size, size)});
        }
        return make_polygon(points, coin() ? 0.1f * size : 0.0f);
    }

    ShapeDef draw_shape_def() {
        const Shape shape = draw_shape();
        const SurfaceMaterial material = draw_material();
        const CollisionFilter filter = draw_filter();
        return {shape, material, filter, integer(0, 9) == 0};
    }

    void add_body() {
        BodyDef def;
        def.type = draw_type();
        def.pose = draw_pose();
        def.locks = draw_locks();
        def.mass = draw_mass();
        def.bullet = coin();
        def.allow_fast_rotation = integer(0, 4) == 0;
        def.enabled = integer(0, 9) > 0;
        def.awake = integer(0, 9) > 0;
        if (def.awake) {
            def.velocity.x = between(-10.0f, 10.0f);
            def.velocity.y = between(-10.0f, 10.0f);
            def.angular_velocity = between(-10.0f, 10.0f);
        }
        const BodyId id = world.create_body(def);
        const int shapes = integer(0, 3);
        for (int i = 0; i < shapes; ++i) world.add_shape(id, draw_shape_def());
    }

    std::optional<JointLimits> draw_limits() {
        if (coin()) return std::nullopt;
        const float lower = unit();
        return JointLimits{lower, lower + unit()};
    }
    std::optional<JointSpring> draw_spring() {
        if (coin()) return std::nullopt;
        const float hertz = between(0.5f, 8.0f);
        return JointSpring{hertz, unit()};
    }
    template <class Motor>
    std::optional<Motor> draw_motor() {
        if (coin()) return std::nullopt;
        const float speed = between(-3.0f, 3.0f);
        return Motor{speed, between(0.0f, 50.0f)};
    }

    // Draws the members that the kind has. The anchors are near each other: joints between distant anchors pull their
    // bodies together at some hundred m/s.
    template <class Def>
    JointDef draw_joint(Def def, BodyId a, BodyId b) {
        def.body_a = a;
        def.body_b = b;
        if constexpr (requires { def.anchor_a; }) {
            const bool b_is_near = a != world.bodies().front();  // the floor's middle may be far
            const Pose pose_a = world.state(a).pose, pose_b = world.state(b).pose;
            const DVec2 between_them = b_is_near ? 0.5 * (pose_a.position + pose_b.position) : pose_b.position;
            const double apart_x = between(-0.2f, 0.2f);
            const double apart_y = between(-0.2f, 0.2f);
            def.anchor_a = to_float(inverse_transform_point(pose_a, between_them));
            def.anchor_b = to_float(inverse_transform_point(pose_b, between_them + DVec2{apart_x, apart_y}));
        }
        if constexpr (requires { def.reference_angle; })
            def.reference_angle =
                static_cast<float>(angle(world.state(b).pose.rotation) - angle(world.state(a).pose.rotation));
        if constexpr (requires { def.length; }) def.length = between(0.1f, 0.4f);
        if constexpr (requires { def.ratio; }) draw_rope(def);
        if constexpr (requires { def.limits; }) def.limits = draw_limits();
        if constexpr (requires { def.spring.has_value(); }) def.spring = draw_spring();
        if constexpr (requires { def.linear_spring; }) def.linear_spring = draw_spring();
        if constexpr (requires { def.angular_spring; }) def.angular_spring = draw_spring();
        if constexpr (requires { def.motor; })
            if constexpr (!requires { def.length; })
                def.motor = draw_motor<typename std::remove_reference_t<decltype(def.motor)>::value_type>();
        if constexpr (requires { def.max_force; }) def.max_force = between(0.0f, 100.0f);
        if constexpr (requires { def.max_torque; }) def.max_torque = between(0.0f, 20.0f);
        if constexpr (requires { def.break_force; })
            if (integer(0, 3) == 0) def.break_force = between(10.0f, 500.0f);
        if constexpr (requires { def.collide_connected; }) def.collide_connected = coin();
        return def;
    }

    // The wheels are above the anchors, and the rope nearly fits.
    void draw_rope(PulleyJointDef& def) {
        const DVec2 a = transform_point(world.state(def.body_a).pose, def.anchor_a);
        const DVec2 b = transform_point(world.state(def.body_b).pose, def.anchor_b);
        const float side_a = between(0.3f, 3.0f);
        const float side_b = between(0.3f, 3.0f);
        def.ground_anchor_a = a + DVec2{0.0, side_a};
        def.ground_anchor_b = b + DVec2{0.0, side_b};
        def.ratio = between(0.5f, 2.0f);
        def.length = side_a + def.ratio * side_b + between(-0.2f, 0.2f);
    }

    GearJointDef draw_gear(JointId a, JointId b) {
        GearJointDef def;
        def.joint_a = a;
        def.joint_b = b;
        const float size = between(0.3f, 3.0f);
        def.ratio = coin() ? size : -size;
        if (integer(0, 3) == 0) def.break_torque = between(1.0f, 50.0f);
        def.collide_connected = coin();
        return def;
    }

    // On two of the joints that turn or slide, if there are two.
    void add_gear() {
        std::vector<JointId> motions;
        for (const JointId id : world.joints())
            if (world.joint(id).index() == 0 || world.joint(id).index() == 2) motions.push_back(id);
        const auto a = pick(std::span<const JointId>(motions)), b = pick(std::span<const JointId>(motions));
        if (a && *a != *b) world.create_joint(draw_gear(*a, *b));
    }

    JointDef draw_joint(int kind, BodyId a, BodyId b) {
        switch (kind) {
            case 0: return draw_joint(RevoluteJointDef{}, a, b);
            case 1: return draw_joint(DistanceJointDef{}, a, b);
            case 2: return draw_joint(PrismaticJointDef{}, a, b);
            case 3: return draw_joint(WeldJointDef{}, a, b);
            case 4: return draw_joint(WheelJointDef{}, a, b);
            case 5: return draw_joint(MotorJointDef{}, a, b);
            case 6: return draw_joint(MouseJointDef{}, a, b);
            case 8: return draw_joint(PulleyJointDef{}, a, b);
            default: return draw_joint(FilterJointDef{}, a, b);
        }
    }

    bool is_jointed(BodyId id) const {
        return std::ranges::any_of(world.joints(), [&](JointId joint) {
            return std::visit([&](const auto& def) { return def.body_a == id || def.body_b == id; },
                              world.joint(joint));
        });
    }

    void add_joint() {
        const int kind = integer(0, 10);
        if (kind > 8) return add_gear();
        const auto a = pick(world.bodies()), b = pick(world.bodies().subspan(1));
        if (!a || !b || *a == *b) return;
        // A body without a joint moves near A. A distant body would be on a long lever.
        if (!is_jointed(*b)) world.set_transform(*b, draw_move(*a));
        const DVec2 apart = world.state(*b).pose.position - world.state(*a).pose.position;
        if (*a == world.bodies().front() || length(apart) < 2.0) world.create_joint(draw_joint(kind, *a, *b));
    }

    void redefine_joint() {
        const auto id = pick(world.joints());
        if (!id) return;
        const JointDef old = world.joint(*id);
        if (const auto* gear = std::get_if<GearJointDef>(&old))
            return world.set_joint(*id, draw_gear(gear->joint_a, gear->joint_b));
        const auto bodies = std::visit([](const auto& def) { return std::pair(def.body_a, def.body_b); }, old);
        world.set_joint(*id, draw_joint(static_cast<int>(old.index()), bodies.first, bodies.second));
    }

    void set_velocity() {
        const auto id = pick(world.bodies());
        if (!id || !world.is_enabled(*id) || world.type(*id) == BodyType::static_body) return;
        const float x = between(-10.0f, 10.0f);
        const float y = between(-10.0f, 10.0f);
        world.set_velocity(*id, {x, y}, between(-10.0f, 10.0f));
    }

    void push() {
        const auto id = pick(world.bodies());
        if (!id) return;
        const float strength = between(0.0f, 5.0f) * world.mass(*id).mass;
        const DVec2 at = world.state(*id).pose.position;
        world.apply_force(*id, {10.0f * strength, 0.0f}, at);
        world.apply_impulse(*id, {0.0f, strength}, at);
    }
};

}  // namespace tumble::test
