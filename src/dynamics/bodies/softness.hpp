// Soft constraints: a spring and damper given by frequency and damping ratio, integrated implicitly over a sub-step.
//
// The impulse is - mass * (mass_scale * (relative velocity + bias_rate * error)) - impulse_scale * (accumulated
// impulse) [Catto 2011, "Soft Constraints"; Catto 2024, "Solver2D"; derived in ../SOFTNESS.md]. Stable for any
// stiffness, if `mass` is the mass that the impulse moves. A rigid constraint is {0, 1, 0}.
#pragma once

#include <algorithm>

#include "debug/check.hpp"
#include "dynamics/bodies/constants.hpp"
#include "tumble/joint.hpp"

namespace tumble {

struct Softness {
    float bias_rate = 0.0f;      // 1/s
    float mass_scale = 1.0f;     // part of the rigid impulse
    float impulse_scale = 0.0f;  // part of the accumulated impulse that is taken back
};

// `h` is the sub-step, s.
inline Softness make_softness(float hertz, float damping_ratio, float h) {
    TUMBLE_CHECK(hertz >= 0.0f);
    TUMBLE_CHECK(damping_ratio >= 0.0f);
    TUMBLE_CHECK(h > 0.0f);
    const float omega = 2.0f * static_cast<float>(kPi) * hertz;
    const float a1 = 2.0f * damping_ratio + h * omega;
    const float a2 = h * omega * a1;
    const float a3 = 1.0f / (1.0f + a2);
    return {omega / a1, a2 * a3, a3};
}

inline float contact_hertz(const Tuning& tuning, float h) {
    return std::min(tuning.contact_hertz, kContactHertzPerSubstep / h);
}

inline Softness contact_softness(const Tuning& tuning, float h) {
    return make_softness(contact_hertz(tuning, h), kContactDampingRatio, h);
}

inline Softness static_contact_softness(const Tuning& tuning, float h) {
    return make_softness(kStaticStiffening * contact_hertz(tuning, h), kContactDampingRatio, h);
}

inline Softness joint_softness(const Tuning& tuning, float h) {
    return make_softness(std::min(tuning.joint_hertz, kJointHertzPerSubstep / h), kJointDampingRatio, h);
}

inline float stiffest_spring(float h) { return kSpringHertzPerSubstep / h; }  // Hz

inline Softness spring_softness(const JointSpring& spring, float h) {
    return make_softness(std::min(spring.hertz, stiffest_spring(h)), spring.damping_ratio, h);
}

}  // namespace tumble
