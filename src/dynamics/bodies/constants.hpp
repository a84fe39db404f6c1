// Every tuning constant of the stepper, with unit, reason, and what breaks if it changes.
//
// The values are those that today's soft-step engines agree on (Box2D 3.x, Rapier), so that scenes behave alike;
// lengths are relative to the shapes, so that a 2 cm ball does not touch at a 2 cm gap. Those in m, m/s, Hz and s are
// for things of 1 m: a world of another scale has the values of its Tuning.
#pragma once

#include <algorithm>
#include <cmath>

#include "tumble/math.hpp"

namespace tumble {

// Contact softness, Hz and damping ratio. Stiff enough to hide the sag F / (m w^2), soft enough for the sub-step: the
// frequency is further limited to kContactHertzPerSubstep / h. Higher: stacks jitter. Lower: they sink visibly.
inline constexpr float kContactHertz = 30.0f;
inline constexpr float kContactDampingRatio = 10.0f;
inline constexpr float kContactHertzPerSubstep = 0.125f;

// Of the part of an impulse that a soft contact takes back in a sub-step, how much of it acts on what the contact bore
// when the step began, and on what has come since. The first is the sag, F / (m w^2) times this part: 1 is the plain
// spring, where 20 boxes sink by 135 mm. The second is what keeps piles from bouncing: an impact of several boxes is
// passed on in impulses too large, which fade.
//
// Lower: 0.35 never comes to rest in a pyramid of 100 rows, 0.25 flies apart, and 0 shakes a stack of 20. Impulses and
// velocities of a tall pile make a wave, whose stiffness m for slow motion is about 1.75 m / h^2 as one pass over the
// contacts gives it; springs must stay softer, and (w h)^2 / part is 1.23. Load averaged over steps (5 to 30 % a step)
// bounces less by itself and rocks large piles more. A higher frequency sags and rocks alike, and bounces more.
// Faster fading than 4: bodies sink in more at impacts and rocking grows.
inline constexpr float kCarriedSoftness = 0.5f;
inline constexpr float kFreshSoftness = 4.0f;

// Against a static body contacts are this much stiffer: it cannot give way, so that there is no risk of jitter.
inline constexpr float kStaticStiffening = 2.0f;

// The fastest that overlap is pushed out, m/s. Higher: bodies created inside each other explode. Lower: a fast impact
// stays visibly sunk in for several steps.
inline constexpr float kPushOutSpeed = 3.0f;

// Joint softness. Higher than contacts, as joints are never to open visibly; over 0.25 / h it would not be stable.
inline constexpr float kJointHertz = 60.0f;
inline constexpr float kJointDampingRatio = 2.0f;
inline constexpr float kJointHertzPerSubstep = 0.25f;

// Springs of joints: no stiffer than this / h, just under 1 / (2 pi). An implicit spring is stable on the mass that it
// was made for. What else holds the bodies makes them heavier, and then the impulse of the last sub-step lags behind by
// h (w h) a1 (see softness.hpp): of the damping a1 w there remains a1 w (1 - (w h)^2). Higher: a row of boards welded
// by springs of 60 Hz shakes itself to pieces.
inline constexpr float kSpringHertzPerSubstep = 0.15f;

// Approach speed below which a contact does not bounce, m/s. Lower: resting bodies hop for ever, as one sub-step of
// gravity is read as an approach. Higher: slow bounces stick.
inline constexpr float kRestitutionThreshold = 1.0f;

// Approach speed from which a meeting is a hit, m/s. Lower: what rests and rocks is heard. Higher: what falls by 5 cm
// is not.
inline constexpr float kHitSpeed = 1.0f;

// Contacts begin at this gap (m; part of the smaller extent): bodies are stopped before they touch, not pushed out
// afterwards. Larger: ghost contacts at corners that would be missed. Smaller: impacts sink in first.
inline constexpr float kSpeculativeDistance = 0.02f;
inline constexpr float kSpeculativePart = 0.1f;

// A contact is recycled while its shapes have moved against each other by less than this part of the speculative
// distance: 0.5 mm at human scale. Larger: contact points lag behind the shapes. Smaller: more full collisions.
inline constexpr float kRecyclingPart = 0.025f;

// How much larger a box in the tree is than its shape (m; part of the smaller extent). Larger: more pairs to look at.
// Smaller: the tree is updated more often.
inline constexpr float kAabbMargin = 0.05f;
inline constexpr float kAabbMarginPart = 0.125f;

// An island falls asleep when no point of it has moved faster than this (m/s) for this long (s). Faster: what creeps
// is frozen in mid-air. Slower, or longer: settled piles go on costing time.
inline constexpr float kSleepSpeed = 0.05f;
inline constexpr float kTimeToSleep = 0.5f;

// Speed limit, m/s: 6.7 m in a step at 60 Hz. Beyond, float deltas and the tree lose their meaning.
inline constexpr float kMaxSpeed = 400.0f;

// Continuous collision looks at bodies that move by more than this part of their smallest extent in a step: who moves
// less overlaps visibly at most, and is pushed back. Smaller: more sweeps. Larger: thin things are passed.
inline constexpr float kContinuousPart = 0.5f;

// The part of a shape that must not pass: the rest may sink in and is pushed out. Larger: sliding over seams stops.
// Smaller: deeper overlap. The inner parts are for shapes that have sunk in deeper already: they go no further.
inline constexpr float kContinuousCores[] = {0.75f, 0.5f, 0.25f, 0.0f};

// Rotation limit a step, rad: an eighth of a turn. More breaks the linearisation of contacts within the step, and
// continuous collision. A body may be allowed more (wheels, projectiles: round things), up to half a turn a sub-step:
// beyond, nothing in the step tells which way it turned.
inline constexpr float kMaxRotation = static_cast<float>(0.25 * kPi);
inline constexpr float kMaxFastRotation = static_cast<float>(kPi);

// Bodies that are locked along an axis are at a dead point where they give way by less than this part of what they
// would without the lock: pushed within 6 degrees of the locked axis. Smaller: such pushes throw them aside. Larger:
// they are held less.
inline constexpr float kDeadPoint = 0.01f;

// Colours of the constraint graph: those of contacts between moving bodies, and of contacts with one that is not
// dynamic. The latter are solved last in each pass, which makes the ground win. Together at most 24: with more, the
// last colours hold too few contacts to fill lanes. What finds no colour is solved alone in a lane group.
inline constexpr int kDynamicColors = 16;
inline constexpr int kStaticColors = 8;

// The constants of a world whose typical body is `scale` m large. Under the same gravity, lengths s take times sqrt(s).
struct Tuning {
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
    float aabb_margin(float smaller_extent) const {
        return std::min(max_aabb_margin, kAabbMarginPart * smaller_extent);
    }
};

inline Tuning make_tuning(float scale) {
    const float root = std::sqrt(scale), inverse = 1.0f / root;
    return {.max_speculative_distance = scale * kSpeculativeDistance,
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
