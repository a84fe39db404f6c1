// Bodies and the shapes on them, as a user defines them.
#pragma once

#include <cstdint>
#include <optional>

#include "tumble/chain.hpp"
#include "tumble/id.hpp"
#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble {

enum class BodyType : std::uint8_t {
    static_body,     // never moves
    kinematic_body,  // moves by its velocity alone, as if of infinite mass
    dynamic_body,
};

struct BodyMass {
    float mass = 0.0f;  // kg; 0 for static, kinematic and disabled bodies
    Vec2 center;        // centre of mass, body coordinates
    float inertia =
        0.0f;  // about the centre of mass, kg m^2; 0: nothing turns it, and nothing stops a spin that it has

    friend constexpr bool operator==(const BodyMass&, const BodyMass&) = default;
};

// What a dynamic body may not do, in the axes of the world: what is locked has no velocity, and no force changes that.
struct BodyLocks {
    bool x = false;
    bool y = false;
    bool rotation = false;

    friend constexpr bool operator==(const BodyLocks&, const BodyLocks&) = default;
};

struct BodyDef {
    BodyType type = BodyType::dynamic_body;
    Pose pose{};                    // of the body's origin
    Vec2 velocity{};                // of the centre of mass, m/s
    float angular_velocity = 0.0f;  // rad/s
    float linear_damping = 0.0f;    // 1/s: v / (1 + h c) in each sub-step
    float angular_damping = 0.0f;   // 1/s
    float gravity_scale = 1.0f;
    bool allow_fast_rotation = false;  // more than an eighth of a turn a step; for round things
    bool bullet = false;               // kept from passing through dynamic bodies too, not only through others
    bool allow_sleep = true;           // false keeps the body's whole island awake
    bool awake = true;                 // false: a dynamic body starts asleep, at rest, until something touches it
    BodyLocks locks{};
    bool enabled = true;             // false: it is kept, but nothing meets it and it does not move
    std::optional<BodyMass> mass{};  // in place of what the shapes weigh; mass > 0, inertia >= 0; for dynamic bodies
};

// How a surface behaves in contact. Of two surfaces the friction is sqrt(f1 f2), the restitution the larger, the
// rolling resistance the larger times the radius, the tangent speed the sum.
struct SurfaceMaterial {
    float density = 1.0f;             // kg/m^2
    float friction = 0.6f;            // >= 0
    float restitution = 0.0f;         // 0 to 1, applied above 1 m/s
    float rolling_resistance = 0.0f;  // >= 0, of the shape's radius
    float tangent_speed = 0.0f;       // m/s, conveyor belts; positive carries what lies on top to the left

    friend constexpr bool operator==(const SurfaceMaterial&, const SurfaceMaterial&) = default;
};

// Which shapes meet: two with the same group other than 0 do if it is positive and do not if it is negative; all others
// do if each one's mask has a bit of the other's category.
struct CollisionFilter {
    std::uint64_t category = 1;
    std::uint64_t mask = ~std::uint64_t{0};
    std::int32_t group = 0;

    friend constexpr bool operator==(const CollisionFilter&, const CollisionFilter&) = default;
};

constexpr bool may_meet(const CollisionFilter& a, const CollisionFilter& b) {
    if (a.group != 0 && a.group == b.group) return a.group > 0;
    return (a.mask & b.category) != 0 && (b.mask & a.category) != 0;
}

struct ShapeDef {
    Shape shape{};  // in the body's coordinates
    SurfaceMaterial material{};
    CollisionFilter filter{};
    bool sensor = false;  // only notices what overlaps it (not other sensors, and not static if static); has no mass
    std::optional<ChainLink> link{};  // of a chain's segment: the points beside it, so that no seam is felt
};

// What a body is doing at the end of a step.
struct BodyState {
    Pose pose;                      // of the body's origin
    Vec2 velocity;                  // of the centre of mass, m/s
    float angular_velocity = 0.0f;  // rad/s; a body asleep is at rest
};

}  // namespace tumble
