// The hot state of a moving body: all that the solver reads and writes in its inner loops, 32 bytes.
//
// The deltas are measured from the start of the step: positions stay double outside, and the solver works in float
// whatever the distance from the origin.
#pragma once

#include <cstdint>
#include <type_traits>

#include "tumble/math.hpp"

namespace tumble {

enum BodyFlag : std::uint32_t {
    kDynamicBody = 1u << 0,   // has a mass: gravity, damping and impulses act on it
    kFastSpin = 1u << 1,      // may turn by kMaxFastRotation in a sub-step
    kBulletBody = 1u << 2,    // is swept against other dynamic bodies too
    kLockX = 1u << 3,         // has no velocity along the world's x axis,
    kLockY = 1u << 4,         // along y,
    kLockRotation = 1u << 5,  // or of turning
    kClampedBody = 1u << 6,    // went faster than anything may, since the last step ended
};

struct alignas(32) SolverBody {
    Vec2 velocity;  // of the centre of mass
    float angular_velocity = 0.0f;
    std::uint32_t flags = 0;  // BodyFlag
    Vec2 delta_position;      // of the centre of mass
    Rotation delta_rotation;
};
static_assert(sizeof(SolverBody) == 32 && std::is_trivially_copyable_v<SolverBody>);

// The first solver body stands for all that is static: at rest, of infinite mass, never moved.
inline constexpr std::uint32_t kStaticSolverBody = 0;

// What the locks of a body leave of a linear and an angular velocity.
inline Vec2 allowed(std::uint32_t flags, Vec2 velocity) {
    return {flags & kLockX ? 0.0f : velocity.x, flags & kLockY ? 0.0f : velocity.y};
}
inline float allowed(std::uint32_t flags, float angular_velocity) {
    return flags & kLockRotation ? 0.0f : angular_velocity;
}

// A vector with its components multiplied, as masses of locked bodies do it.
constexpr Vec2 scaled(Vec2 factors, Vec2 v) { return {factors.x * v.x, factors.y * v.y}; }

// How constraints see the motion of a body: the velocity of the point at offset `arm` from the centre of mass.
inline Vec2 velocity_at(const SolverBody& body, Vec2 arm) { return body.velocity + cross(body.angular_velocity, arm); }

// The product of rotations: turns by `first`, then by `second`.
constexpr Rotation compose(Rotation second, Rotation first) {
    return {second.c * first.c - second.s * first.s, second.s * first.c + second.c * first.s};
}

// The rotation by a small angle without trigonometry: with t = tan(angle / 2), c = (1 - t^2) / (1 + t^2) and
// s = 2 t / (1 + t^2) have unit length, and t = angle / 2 + angle^3 / 24 errs by angle^5 / 120 only.
constexpr Rotation small_rotation(float angle) {
    const float half = 0.5f * angle;
    const float t = half + half * half * half * (1.0f / 3.0f);
    const float scale = 1.0f / (1.0f + t * t);
    return {(1.0f - t * t) * scale, 2.0f * t * scale};
}

}  // namespace tumble
