// Definitions of bodies and of the shapes on them. Units are m, kg, s and rad; y points up, angles are
// counter-clockwise.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "tumble/chain.hpp"
#include "tumble/id.hpp"
#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble {

enum class BodyType : std::uint8_t {
    static_body,     // does not move
    kinematic_body,  // moves by its velocity only, as if of infinite mass
    dynamic_body,    // moves by forces, contacts and joints
};

struct BodyMass {
    float mass = 0.0f;     // kg; 0 for static, kinematic and disabled bodies
    Vec2 center;           // centre of mass, body coordinates
    float inertia = 0.0f;  // about the centre of mass, kg m^2; 0 means infinite: nothing changes its angular velocity

    friend constexpr bool operator==(const BodyMass&, const BodyMass&) = default;
};

struct Energy {
    double kinetic = 0.0;    // J
    double potential = 0.0;  // J in the gravity of the world; 0 for a centre of mass at the origin
    double total() const { return kinetic + potential; }
};

// Motions that a dynamic body does not make, along the world axes and about its centre of mass. A locked velocity is 0.
struct BodyLocks {
    bool x = false;
    bool y = false;
    bool rotation = false;

    friend constexpr bool operator==(const BodyLocks&, const BodyLocks&) = default;
};

struct BodyDef {
    BodyType type = BodyType::dynamic_body;
    Pose pose{};                       // of the body's origin
    Vec2 velocity{};                   // of the centre of mass, m/s
    float angular_velocity = 0.0f;     // rad/s
    float linear_damping = 0.0f;       // 1/s, >= 0: v / (1 + h c) in each sub-step of h seconds
    float angular_damping = 0.0f;      // 1/s, >= 0
    float gravity_scale = 1.0f;        // factor on the world's gravity
    bool allow_fast_rotation = false;  // more than an eighth of a turn per step; for round shapes
    bool bullet = false;               // swept against dynamic bodies too if ImpactModel is at_step_end
    bool allow_sleep = true;           // false keeps the body's whole island awake
    bool awake = true;                 // false: a dynamic body starts asleep, at rest, until an awake body touches it
    BodyLocks locks{};
    bool enabled = true;             // false: it does not collide or move until World::set_enabled()
    std::optional<BodyMass> mass{};  // replaces the mass of the shapes of a dynamic body; mass > 0, inertia >= 0
    std::uint64_t user_data = 0;     // a number of the caller's: see World::user_data()
};

// How a surface behaves in contact. A contact of two surfaces has the friction sqrt(f1 f2), the larger restitution, the
// larger rolling resistance times the larger radius, and the sum of the tangent speeds.
struct SurfaceMaterial {
    float density = 1.0f;             // kg/m^2
    float friction = 0.6f;            // >= 0
    float restitution = 0.0f;         // 0 to 1; applied to impacts faster than 1 m/s (WorldDef::scale changes it)
    float rolling_resistance = 0.0f;  // >= 0, as a part of the shape's radius
    float tangent_speed = 0.0f;       // m/s, of conveyor belts; positive carries a body on top to the left

    friend constexpr bool operator==(const SurfaceMaterial&, const SurfaceMaterial&) = default;
};

// Which shapes may touch. Two shapes of the same group other than 0 may if the group is positive and may not if it is
// negative. All others may if each one's mask has a bit of the other's category.
struct CollisionFilter {
    std::uint64_t category = 1;
    std::uint64_t mask = ~std::uint64_t{0};
    std::int32_t group = 0;

    friend constexpr bool operator==(const CollisionFilter&, const CollisionFilter&) = default;
};

constexpr bool may_touch(const CollisionFilter& a, const CollisionFilter& b) {
    if (a.group != 0 && a.group == b.group) return a.group > 0;
    return (a.mask & b.category) != 0 && (b.mask & a.category) != 0;
}

struct ShapeDef {
    Shape shape{};  // in the body's coordinates
    SurfaceMaterial material{};
    CollisionFilter filter{};
    bool sensor = false;  // reports overlaps but does not collide, and has no mass; ignores other sensors, and static
                          // bodies if its own body is static
    std::optional<ChainLink> link{};  // if the shape is a chain's segment: see make_chain_links()
    std::uint64_t user_data = 0;      // a number of the caller's: see World::user_data()
};

// The pose and velocity of a body at the end of a step.
struct BodyState {
    Pose pose;                      // of the body's origin
    Vec2 velocity;                  // of the centre of mass, m/s
    float angular_velocity = 0.0f;  // rad/s; a sleeping body has velocity 0
};

// The arrays that World::read_states() fills: entry i is that of World::bodies()[i]. An empty array is left out.
struct BodyStateArrays {
    std::span<DVec2> positions{};           // of the origins, m
    std::span<double> angles{};             // rad in (-pi, pi]
    std::span<Vec2> velocities{};           // of the centres of mass, m/s
    std::span<float> angular_velocities{};  // rad/s
};

}  // namespace tumble
