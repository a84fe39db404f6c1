#include "tumble/world_def.hpp"

#include "dynamics/bodies/constants.hpp"
#include "dynamics/bodies/softness.hpp"

namespace tumble {

WorldLimits world_limits(const WorldDef& def) {
    const float duration = 1.0f / def.steps_per_second, h = duration / static_cast<float>(def.substeps);
    const Tuning tuning = make_tuning(def.scale, def.gravity, duration);
    return {.rest_speed = tuning.sleep_speed,
            .time_to_sleep = tuning.time_to_sleep,
            .max_speed = tuning.max_speed,
            .max_rotation = kMaxRotation,
            .push_out_speed = tuning.push_out_speed,
            .contact_hertz = contact_hertz(tuning, h),
            .static_stiffening = kStaticStiffening,
            .stiffest_spring = stiffest_spring(h)};
}

}  // namespace tumble
