// Every tuning constant of the stepper, with unit, reason, and the effect of a change.
//
// Most values are those on which soft-step engines agree (Box2D 3.x, Rapier), so that scenes behave alike; contacts are
// stiffer. Lengths are limited by the shapes: a 2 cm ball begins a contact at a gap of 2 mm. Values in m, m/s, Hz and s
// are for bodies of 1 m; a world of another scale uses its Tuning. ../SOFTNESS.md derives the limits of the frequencies
// of springs and contacts.
#pragma once

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
#include "tumble/math.hpp"

namespace tumble {

// Contact softness, Hz and damping ratio. Stiff enough to hide the sag F / (m w^2), soft enough for the sub-step h: the
// frequency is also limited to kContactHertzPerSubstep / h. Higher frequency: piles rock more. Lower: stacks sink
// visibly. Higher damping: bodies sink in deeper at impacts. Lower: piles bounce more. See ../SOFTNESS.md, section 3.
inline constexpr float kContactHertz = 42.6f;
inline constexpr float kContactDampingRatio = 8.0f;
inline constexpr float kContactHertzPerSubstep = 0.1775f;

// Contacts with a static or kinematic body are stiffer by this factor: such a body cannot move, so they do not jitter.
inline constexpr float kStaticStiffening = 2.0f;

// Speed limit for removing overlap, m/s. Higher: bodies created inside each other explode. Lower: a body stays visibly
// sunk in for several steps after a fast impact.
inline constexpr float kPushOutSpeed = 2.5f;

// Joint softness, Hz and damping ratio. Stiffer than contacts, because joints must not open visibly; above 0.25 / h it
// is not stable.
inline constexpr float kJointHertz = 60.0f;
inline constexpr float kJointDampingRatio = 2.0f;
inline constexpr float kJointHertzPerSubstep = 0.25f;

// The highest frequency of a joint's spring, times h: just under 1 / (2 pi). Beyond, a spring whose bodies are also
// constrained by others is not damped (../SOFTNESS.md, section 2). Higher: a row of boards welded by springs of 60 Hz
// shakes itself to pieces.
inline constexpr float kSpringHertzPerSubstep = 0.15f;

// Approach speed below which a contact does not bounce, m/s. Lower: resting bodies keep hopping, because the speed that
// gravity adds in one sub-step counts as an approach. Higher: slow bounces stick.
inline constexpr float kRestitutionThreshold = 1.0f;

// Approach speed from which an impact is reported as a hit, m/s. Lower: bodies that rock at rest report hits. Higher: a
// fall of 5 cm does not.
inline constexpr float kHitSpeed = 1.0f;

// Contacts begin at this gap (m; part of the smaller extent), so that the solver stops bodies before they overlap; or
// at the gap that gravity closes in a step, if that is larger (Tuning::contact_distance). Larger: ghost contacts at
// corners that the shapes would miss. Smaller: bodies sink in at impacts.
inline constexpr float kSpeculativeDistance = 0.02f;
inline constexpr float kSpeculativePart = 0.1f;

// A manifold is recycled while the relative displacement of its shapes is less than this part of the speculative
// distance: 0.5 mm for bodies of 1 m. Larger: contact points lag behind the shapes. Smaller: more full collisions.
inline constexpr float kRecyclingPart = 0.025f;

// The same where sharp corners touch an edge, as they are fixed points of their bodies: 5 mm for bodies of 1 m, and at
// most a part of the smaller extent. Larger: corners beyond the end of an edge stay on it.
inline constexpr float kSharpRecyclingPart = 0.25f;
inline constexpr float kSharpRecyclingExtentPart = 0.025f;

// The margin of a box in the tree around its shape (m; part of the smaller extent). Larger: more pairs to collide.
// Smaller: more updates of the tree.
inline constexpr float kAabbMargin = 0.05f;
inline constexpr float kAabbMarginPart = 0.125f;

// An island may fall asleep when none of its points has moved faster than this (m/s) for this long (s). Faster:
// creeping bodies freeze in mid-air. Slower, or longer: settled piles keep costing time.
inline constexpr float kSleepSpeed = 0.05f;
inline constexpr float kTimeToSleep = 0.5f;

// A body that nothing holds drifts if it moves faster than this part of the sleep speed: 1 m in 5 hours. It stays
// awake. Smaller: bodies that rounding has left with a speed never sleep. Larger: slow ones stop in mid-air.
inline constexpr float kDriftPart = 1e-3f;

// Speed limit, m/s: 6.7 m in a step at 60 Hz. Beyond it float deltas lose their precision.
inline constexpr float kMaxSpeed = 400.0f;

// Continuous collision sweeps bodies that move by more than this part of their smallest extent in a step. A body that
// moves less can overlap visibly, but is pushed out on the side it came from. Smaller: more sweeps. Larger: bodies pass
// through thin ones.
inline constexpr float kContinuousPart = 0.5f;

// The core of a shape, as a part of its size, that continuous collision keeps out of other shapes; the solver pushes
// the rest out. Larger: bodies stop when they slide over seams. Smaller: deeper overlap. The smaller cores apply to
// shapes whose larger ones overlap already: they sink in no farther.
inline constexpr float kContinuousCores[] = {0.75f, 0.5f, 0.25f, 0.0f};

// Continuous collision decides with a core that is smaller than the shape by this part of the speculative distance on
// each side: 8 mm for bodies of 1 m. Larger: deeper overlap. Smaller: bodies stop when they slide over seams.
inline constexpr float kContinuousInset = 0.4f;

// Shapes touch during an impact if they are at most this part of the speculative distance apart: 1 mm for bodies of 1
// m. Larger: bodies bounce off before they touch. Smaller: a flat box lands on one corner first.
inline constexpr float kTouchingPart = 0.05f;

// Two bodies that touch after an impact are left alone for at most this part of the step. Smaller: a ball that a
// turning paddle drives has more impacts. Larger: it sinks in deeper.
inline constexpr double kLongestRest = 1.0 / 16.0;

// The weight of a body's impacts in a step, at which it stops. An impact with a bounce weighs 1: a ball at 200 m/s
// between walls 10 cm apart has 33. One without weighs more (kInelasticWeight of continuous/impact_response.cpp).
inline constexpr int kMaxImpactsPerBody = 64;

// Rotation limit per step, rad: an eighth of a turn. More breaks the linearisation of contacts within the step, and
// continuous collision. Bodies with kFastSpin (wheels, projectiles: round ones) may turn up to half a turn per
// sub-step; beyond that the direction of the rotation is ambiguous.
inline constexpr float kMaxRotation = static_cast<float>(0.25 * kPi);
inline constexpr float kMaxFastRotation = static_cast<float>(kPi);

// Of bodies locked along an axis: a contact row whose response is below this part of the response without the lock is
// not solved. That is a push within 6 degrees of the locked axis. Smaller: such pushes give large speeds across the
// axis. Larger: contacts near the axis stop working.
inline constexpr float kDeadPoint = 0.01f;

// Colours of the constraint graph: for contacts between dynamic bodies, and for contacts with a static or kinematic
// one. The latter are solved last in each pass, so that no later contact presses a body into the ground again. Together
// at most 24: the last of more colours have too few contacts to fill lanes. A contact without a colour has a block of
// its own.
inline constexpr int kDynamicColors = 16;
inline constexpr int kStaticColors = 8;

// The constants of a world whose typical body has the size `scale` (m). Under the same gravity a length s takes a time
// sqrt(s).
struct Tuning {
    float fall_in_step = 0.0f;  // the speed that gravity adds in a step, times the step, m
    float max_speculative_distance = kSpeculativeDistance;
    float max_aabb_margin = kAabbMargin;
    float push_out_speed = kPushOutSpeed;
    float restitution_threshold = kRestitutionThreshold;
    float hit_speed = kHitSpeed;
    float sleep_speed = kSleepSpeed;
    float max_speed = kMaxSpeed;
    float contact_hertz = kContactHertz;
    float joint_hertz = kJointHertz;
    float time_to_sleep = kTimeToSleep;

    float speculative_distance(float smaller_extent) const {
        return std::min(max_speculative_distance, kSpeculativePart * smaller_extent);
    }
    // Of a contact that begins: also at least the gap that a body at rest can close in a step. Without it the second
    // corner of a thin card sinks in before it has a contact point: 10 of 40 card houses fall.
    float contact_distance(float smaller_extent) const {
        return std::max(speculative_distance(smaller_extent), std::min(max_speculative_distance, fall_in_step));
    }
    float aabb_margin(float smaller_extent) const {
        return std::min(max_aabb_margin, kAabbMarginPart * smaller_extent);
    }
};

// `gravity` (m/s^2) and the `duration` of a step (s) are those of the world.
inline Tuning make_tuning(float scale, Vec2 gravity, float duration) {
    TUMBLE_CHECK(scale > 0.0f);
    TUMBLE_CHECK(duration > 0.0f);
    const float root = std::sqrt(scale), inverse = 1.0f / root;
    return {.fall_in_step = length(gravity) * duration * duration,
            .max_speculative_distance = scale * kSpeculativeDistance,
            .max_aabb_margin = scale * kAabbMargin,
            .push_out_speed = root * kPushOutSpeed,
            .restitution_threshold = root * kRestitutionThreshold,
            .hit_speed = root * kHitSpeed,
            .sleep_speed = root * kSleepSpeed,
            .max_speed = root * kMaxSpeed,
            .contact_hertz = inverse * kContactHertz,
            .joint_hertz = inverse * kJointHertz,
            .time_to_sleep = root * kTimeToSleep};
}

}  // namespace tumble
