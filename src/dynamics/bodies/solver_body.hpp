// The state of a moving body that the solver reads and writes in its inner loops: 32 bytes.
//
// Deltas are measured from the start of the step. So poses stay double outside, and the solver works in float at any
// distance from the origin.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "tumble/math.hpp"

namespace tumble {

enum BodyFlag : std::uint32_t {
    kDynamicBody = 1u << 0,   // gravity, damping and impulses act on it
    kFastSpin = 1u << 1,      // may turn by kMaxFastRotation in a sub-step
    kBulletBody = 1u << 2,    // continuous collision sweeps it against dynamic bodies too
    kLockX = 1u << 3,         // has no velocity along the world's x axis
    kLockY = 1u << 4,         // has no velocity along the world's y axis
    kLockRotation = 1u << 5,  // has no angular velocity
    kClampedBody = 1u << 6,   // exceeded a speed limit since the last step ended: see clamp_speed()
    kPushedBody = 1u << 7,    // a contact or joint acted on it in this step
};

struct alignas(32) SolverBody {
    Vec2 velocity;  // of the centre of mass
    float angular_velocity = 0.0f;
    std::uint32_t flags = 0;  // BodyFlag
    Vec2 delta_position;      // of the centre of mass
    Rotation delta_rotation;
};
static_assert(sizeof(SolverBody) == 32 && std::is_trivially_copyable_v<SolverBody>);

// The solver body of all bodies that do not move: at rest, of infinite mass.
inline constexpr std::uint32_t kStaticSolverBody = 0;

// Solver bodies from `begin` up to `end`.
struct BodyRange {
    std::size_t begin = 0;
    std::size_t end = 0;
};

// The components of a velocity that the locks of a body allow.
inline Vec2 allowed(std::uint32_t flags, Vec2 velocity) {
    return {flags & kLockX ? 0.0f : velocity.x, flags & kLockY ? 0.0f : velocity.y};
}
inline float allowed(std::uint32_t flags, float angular_velocity) {
    return flags & kLockRotation ? 0.0f : angular_velocity;
}

// The componentwise product: inverse masses of locked bodies differ by axis.
constexpr Vec2 scaled(Vec2 factors, Vec2 v) { return {factors.x * v.x, factors.y * v.y}; }

// The velocity of the point at the offset `arm` from the centre of mass (world axes, m).
inline Vec2 velocity_at(const SolverBody& body, Vec2 arm) { return body.velocity + cross(body.angular_velocity, arm); }

// The rotation by `first`, then by `second`: two Rotations, or two LaneTurns.
template <class Turn>
constexpr Turn compose(const Turn& second, const Turn& first) {
    return {second.c * first.c - second.s * first.s, second.s * first.c + second.c * first.s};
}

// The rotation that leads from one orientation to another: two Rotations, or two LaneTurns.
template <class Turn>
constexpr Turn rotation_between(const Turn& from, const Turn& to) {
    return {to.c * from.c + to.s * from.s, to.s * from.c - to.c * from.s};
}

// At least the size of a rotation's angle, rad, without an arc tangent: an angle of up to a quarter turn is at most
// pi / 2 times its sine, and any is at most pi.
inline float angle_bound(Rotation turn) { return turn.c > 0.0f ? 1.58f * std::abs(turn.s) : 3.15f; }

// The rotation by a small angle (rad) without trigonometry. With t = tan(angle / 2), c = (1 - t^2) / (1 + t^2) and
// s = 2 t / (1 + t^2) have unit length; the series t = angle / 2 + angle^3 / 24 has the error angle^5 / 120. The angle
// is a float, or lanes of them.
template <class Turn = Rotation, class Angle>
constexpr Turn small_rotation(const Angle& angle) {
    const Angle half = 0.5f * angle;
    const Angle t = half + half * half * half * (1.0f / 3.0f);
    const Angle scale = 1.0f / (1.0f + t * t);
    return {(1.0f - t * t) * scale, 2.0f * t * scale};
}

}  // namespace tumble
