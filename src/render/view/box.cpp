#include "render/view/box.hpp"

#include <cmath>

namespace tumble::render {

Box box_of(const Shape& shape, const Pose& pose) {
    const Aabb box = bounds(shape, pose);
    if (!is_finite(box.lower) || !is_finite(box.upper)) return {};
    return {DVec2(box.lower), DVec2(box.upper)};
}

Box box_of(const World& world, BodyId body) {
    const Pose pose = world.state(body).pose;
    Box box;
    for (const ShapeId shape : world.shapes(body)) box.add(box_of(world.shape(shape), pose));
    return box;
}

Box swept_box(const World& world, BodyId body, Vec2 pivot) {
    double radius = 0.0;
    for (const ShapeId shape : world.shapes(body))
        radius = std::max(radius, double{farthest_distance(world.shape(shape), pivot)});
    const DVec2 center = transform_point(world.state(body).pose, pivot);
    if (!is_finite(center) || !std::isfinite(radius)) return {};
    return {center - DVec2{radius, radius}, center + DVec2{radius, radius}};
}

Box box_around(std::span<const DVec2> points) {
    Box box;
    for (const DVec2 point : points) box.add({point, point});
    return box;
}

}  // namespace tumble::render
