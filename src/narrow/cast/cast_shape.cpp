// cast_shape(): validity, the clipped path of the origin, and the result that its start and first contact give.
#include "narrow/cast/cast_result.hpp"

namespace tumble {

CastResult cast_shape(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                      DVec2 translation, double target) noexcept {
    const CorePair pair = make_core_pair(a, world_from_a, b, world_from_b);
    const bool is_target_valid = target >= 0.0 && target <= kLargestScale;
    if (!is_valid(pair, a, b) || !is_valid_motion(translation) || !is_target_valid) return invalid_cast();
    const double radius_a = a.radius(), reach = (radius_a + b.radius()) + target;
    const CastPath path = make_path(pair, translation, reach);
    return cast_result(clip_path(pair, path), path, pair.a, radius_a, world_from_a.position);
}

}  // namespace tumble
