// Ray casts: a shape cast of a point, with short ways for circles and for sharp polygons of up to eight vertices.
#include "narrow/cast_ray.hpp"

namespace tumble {

CastResult cast_ray(const Shape& shape, const Pose& world_from_shape, DVec2 origin, DVec2 translation) noexcept {
    static constexpr float kPoint = 0.0f;
    const DVec2 offset = origin - world_from_shape.position;
    const double scale = turned_radius(shape, world_from_shape.rotation) + length(offset);
    const CorePair pair{make_core(shape, world_from_shape.rotation), {&kPoint, &kPoint, 1, 1.0, 0.0, nullptr}, offset, scale};
    if (!is_valid(pair, shape, shape) || !is_valid_motion(translation)) return invalid_cast();
    const double radius = shape.radius();
    const CastPath path = make_path(pair, translation, radius);
    RayEntry entry;
    if (shape.vertex_count() == 1) {
        entry = enter_lone_circle(pair, path);
    } else if (radius == 0.0 && shape.vertex_count() > 2 && shape.vertex_count() <= Shape::kInlineVertices) {
        entry = enter_sharp_polygon(pair, path);
    }
    if (entry.outcome == RayOutcome::misses) return missed(shape.vertex_count());
    const DVec2 position = world_from_shape.position;
    if (entry.outcome == RayOutcome::enters) return met_at(entry.contact, shape.vertex_count(), pair.a, radius, position);
    return cast_result(clip_path(pair, path), path, pair.a, radius, position);
}

}  // namespace tumble
