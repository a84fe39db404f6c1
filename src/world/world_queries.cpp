// Queries: each checks its arguments and calls queries.hpp.
#include "world/input_checks.hpp"
#include "world/queries.hpp"
#include "world/require.hpp"
#include "world/world_impl.hpp"

namespace tumble {

namespace {

void check_path(DVec2 origin, DVec2 translation) {
    require(is_finite(origin), "origin", "finite", origin);
    require(is_finite(translation), "translation", "finite", translation);
}

}  // namespace

std::optional<CastHit> World::cast_ray(DVec2 origin, DVec2 translation, const QueryFilter& filter) const {
    check_path(origin, translation);
    return find_ray_hit(impl_->simulation, origin, translation, filter);
}

std::vector<CastHit> World::cast_ray_all(DVec2 origin, DVec2 translation, const QueryFilter& filter) const {
    check_path(origin, translation);
    return find_ray_hits(impl_->simulation, origin, translation, filter);
}

std::optional<CastHit> World::cast_shape(const Shape& shape, const Pose& pose, DVec2 translation,
                                         const QueryFilter& filter) const {
    check(shape);
    check_pose(pose, "shape");
    check_path(pose.position, translation);
    return find_shape_hit(impl_->simulation, shape, pose, translation, filter);
}

std::vector<ShapeId> World::overlap_shape(const Shape& shape, const Pose& pose, const QueryFilter& filter) const {
    check(shape);
    check_pose(pose, "shape");
    return find_overlaps(impl_->simulation, shape, pose, filter);
}

std::vector<ShapeId> World::overlap_box(DVec2 lower, DVec2 upper, const QueryFilter& filter) const {
    require(is_finite(lower), "lower corner", "finite", lower);
    require(is_finite(upper), "upper corner", "finite", upper);
    require(lower.x <= upper.x && lower.y <= upper.y, "upper corner", "at least the lower corner in x and y", upper);
    return find_overlaps(impl_->simulation, lower, upper, filter);
}

std::optional<ClosestHit> World::closest(DVec2 point, double max_distance, const QueryFilter& filter) const {
    check_point(point);
    require(max_distance >= 0.0, "max_distance", "0 or more", max_distance);
    return find_closest(impl_->simulation, point, max_distance, filter);
}

BodyDistance World::distance(BodyId a, BodyId b) const {
    impl_->require(a);
    impl_->require(b);
    return find_distance(impl_->simulation, a, b);
}

}  // namespace tumble
