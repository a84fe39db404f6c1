// Motion along a constant acceleration, as the integration scheme keeps it.
#pragma once

namespace tumble {

// The square of the speed after a displacement along a constant acceleration; negative if the body turns back before.
// The scheme conserves v^2 - 2 a x exactly if v is the velocity in the middle of a sub-step, v_start + a h / 2.
template <class Real>
Real speed_sq_after(const Real& velocity, const Real& displacement, const Real& acceleration) {
    return velocity * velocity + 2.0f * acceleration * displacement;
}

}  // namespace tumble
