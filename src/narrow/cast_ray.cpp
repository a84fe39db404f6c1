// Ray casts: a shape cast of a point.
#include "narrow/cast_result.hpp"

namespace tumble {

CastResult cast_ray(const Shape& shape, const Pose& world_from_shape, DVec2 origin, DVec2 translation) noexcept {
    static constexpr float kPoint = 0.0f;
    const DVec2 offset = origin - world_from_shape.position;
    const double scale = turned_radius(shape, world_from_shape.rotation) + length(offset);
    const CorePair pair{make_core(shape, world_from_shape.rotation), {&kPoint, &kPoint, 1, 1.0, 0.0}, offset, scale};
    if (!is_valid(pair, shape, shape) || !is_valid_motion(translation)) return invalid_cast();
    const CastPath path = make_path(pair, translation, shape.radius());
    return cast_result(clip_path(pair, path), path, pair.a, shape.radius(), world_from_shape.position);
}

}  // namespace tumble
