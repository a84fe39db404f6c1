#include "world/queries.hpp"

#include <algorithm>
#include <cmath>

#include "tumble/cast.hpp"
#include "tumble/compound.hpp"

namespace tumble {

namespace {

// The boxes in the tree contain their shapes exactly, but tests against them are computed in double and round by a few
// ulp of the coordinates. This relative margin is far above that rounding and far below the size of any shape.
constexpr double kBoxTolerance = 1e-12;

// The margin of a test of a box against a point, m.
double rounding_margin(const Aabb& box, DVec2 from) {
    const double largest =
        std::max({std::abs(static_cast<double>(box.lower.x)), std::abs(static_cast<double>(box.lower.y)),
                  std::abs(static_cast<double>(box.upper.x)), std::abs(static_cast<double>(box.upper.y)),
                  std::abs(from.x), std::abs(from.y)});
    return kBoxTolerance * largest;
}

bool is_included(const Simulation& simulation, std::uint32_t shape, const QueryFilter& filter) {
    const ShapeRecord& record = simulation.shapes[shape];
    return (filter.sensors || !record.is_sensor) && may_touch(filter.shape, record.filter) &&
           simulation.bodies.ids.at(record.body) != filter.except;
}

const Pose& pose_of(const Simulation& simulation, std::uint32_t shape) {
    return simulation.bodies.frames[simulation.shapes[shape].body].pose;
}

ShapeId shape_id(const Simulation& simulation, std::uint32_t shape) { return simulation.shapes.ids.at(shape); }

BodyId body_id(const Simulation& simulation, std::uint32_t shape) {
    return simulation.bodies.ids.at(simulation.shapes[shape].body);
}

// A box that moves along a path. It touches another box where the path of its center touches that box grown by its half
// size; the path is clipped to one slab per axis.
class SweptBox {
public:
    // The margin is far above the rounding of sides up to twice as far from the origin as any point of the path. A side
    // beyond that is out of reach by more than its own rounding.
    SweptBox(DVec2 from, DVec2 translation, DVec2 half)
        : from_(from), inverse_{1.0 / translation.x, 1.0 / translation.y} {
        const double margin = 2.0 * kBoxTolerance * (size(from) + size(translation) + size(half));
        half_ = half + DVec2{margin, margin};
    }

    // True if it touches the box no later than at the fraction `last` of the path.
    bool touches(const Aabb& box, double last) const {
        double first = 0.0;
        return clip(from_.x, inverse_.x, half_.x, box.lower.x, box.upper.x, first, last) &&
               clip(from_.y, inverse_.y, half_.y, box.lower.y, box.upper.y, first, last);
    }

private:
    // `inverse` is infinite if the path does not move along this axis.
    static bool clip(double from, double inverse, double half, double lower, double upper, double& first,
                     double& last) {
        const double to_lower = lower - half - from, to_upper = upper + half - from;
        if (!std::isfinite(inverse)) return to_lower <= 0.0 && to_upper >= 0.0;
        constexpr double kMargin = 1e-15;  // a few ulp of a fraction, for the rounding of the inverse and the products
        const double a = to_lower * inverse, b = to_upper * inverse;
        first = std::max(first, std::min(a, b) - kMargin);
        last = std::min(last, std::max(a, b) + kMargin);
        return first <= last;
    }

    static double size(DVec2 v) { return std::abs(v.x) + std::abs(v.y); }

    DVec2 from_;
    DVec2 inverse_;  // one over the components of the translation
    DVec2 half_;     // with the margin
};

bool comes_first(const CastHit& a, const CastHit& b) {
    return a.fraction != b.fraction ? a.fraction < b.fraction : a.shape < b.shape;
}

std::optional<CastHit> hit_by_ray(const Simulation& simulation, std::uint32_t shape, DVec2 origin, DVec2 translation) {
    const CastResult cast = cast_ray(simulation.shapes[shape].shape, pose_of(simulation, shape), origin, translation);
    if (cast.status != CastStatus::hit) return std::nullopt;
    return CastHit{shape_id(simulation, shape), body_id(simulation, shape), cast.fraction, cast.point, cast.normal};
}

std::optional<CastHit> hit_by_shape(const Simulation& simulation, std::uint32_t other, const Shape& shape,
                                    const Pose& pose, DVec2 translation) {
    const CastResult cast =
        cast_shape(simulation.shapes[other].shape, pose_of(simulation, other), shape, pose, translation);
    const bool inside = cast.status == CastStatus::overlapping;
    if (!inside && cast.status != CastStatus::hit) return std::nullopt;
    CastHit hit{
        shape_id(simulation, other), body_id(simulation, other), cast.fraction, cast.point, cast.normal, inside};
    if (inside) hit.fraction = 0.0;
    return hit;
}

// The first of the hits that find_hit(shape) returns along a path.
template <class FindHit>
std::optional<CastHit> find_first(const Simulation& simulation, const SweptBox& swept, const QueryFilter& filter,
                                  FindHit&& find_hit) {
    std::optional<CastHit> first;
    double last = 1.0;
    simulation.broad.search([&](const Aabb& box) { return swept.touches(box, last); },
                            [&](std::uint32_t shape) {
                                if (!is_included(simulation, shape, filter)) return;
                                const std::optional<CastHit> hit = find_hit(shape);
                                if (!hit || (first && !comes_first(*hit, *first))) return;
                                first = hit;
                                last = hit->fraction;
                            });
    return first;
}

}  // namespace

std::optional<CastHit> find_ray_hit(const Simulation& simulation, DVec2 origin, DVec2 translation,
                                    const QueryFilter& filter) {
    return find_first(simulation, SweptBox(origin, translation, {}), filter,
                      [&](std::uint32_t shape) { return hit_by_ray(simulation, shape, origin, translation); });
}

std::vector<CastHit> find_ray_hits(const Simulation& simulation, DVec2 origin, DVec2 translation,
                                   const QueryFilter& filter) {
    const SweptBox swept(origin, translation, {});
    std::vector<CastHit> hits;
    simulation.broad.search([&](const Aabb& box) { return swept.touches(box, 1.0); },
                            [&](std::uint32_t shape) {
                                if (!is_included(simulation, shape, filter)) return;
                                if (const auto hit = hit_by_ray(simulation, shape, origin, translation))
                                    hits.push_back(*hit);
                            });
    std::sort(hits.begin(), hits.end(), comes_first);
    return hits;
}

std::optional<CastHit> find_shape_hit(const Simulation& simulation, const Shape& shape, const Pose& pose,
                                      DVec2 translation, const QueryFilter& filter) {
    const Aabb box = bounds(shape, pose);
    const DVec2 lower(box.lower), upper(box.upper);
    const SweptBox swept(0.5 * (lower + upper), translation, 0.5 * (upper - lower));
    return find_first(simulation, swept, filter,
                      [&](std::uint32_t other) { return hit_by_shape(simulation, other, shape, pose, translation); });
}

std::vector<ShapeId> find_overlaps(const Simulation& simulation, const Shape& shape, const Pose& pose,
                                   const QueryFilter& filter) {
    std::vector<ShapeId> found;
    simulation.broad.query(bounds(shape, pose), [&](std::uint32_t other) {
        if (!is_included(simulation, other, filter)) return;
        const DistanceResult gap = distance(simulation.shapes[other].shape, pose_of(simulation, other), shape, pose);
        if (gap.status == DistanceStatus::overlapping || gap.status == DistanceStatus::touching)
            found.push_back(shape_id(simulation, other));
    });
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<ShapeId> find_overlaps(const Simulation& simulation, DVec2 lower, DVec2 upper, const QueryFilter& filter) {
    // Compared in double: far from the origin, corners rounded to float would include or leave out shapes.
    const auto touches = [&](const Aabb& box) {
        return box.lower.x <= upper.x && lower.x <= box.upper.x && box.lower.y <= upper.y && lower.y <= box.upper.y;
    };
    std::vector<ShapeId> found;
    simulation.broad.search(touches, [&](std::uint32_t shape) {
        if (is_included(simulation, shape, filter) &&
            touches(bounds(simulation.shapes[shape].shape, pose_of(simulation, shape))))
            found.push_back(shape_id(simulation, shape));
    });
    std::sort(found.begin(), found.end());
    return found;
}

std::optional<ClosestHit> find_closest(const Simulation& simulation, DVec2 point, double max_distance,
                                       const QueryFilter& filter) {
    const Shape probe = make_circle(0.0f);
    const Pose at_point{point, {}};
    std::optional<ClosestHit> best;
    double limit = max_distance;
    const auto may_contain = [&](const Aabb& box) {
        const double x = std::max({box.lower.x - point.x, 0.0, point.x - box.upper.x});
        const double y = std::max({box.lower.y - point.y, 0.0, point.y - box.upper.y});
        // A negative limit does not bound boxes: of several shapes that contain the point, the deepest may have any.
        return length(DVec2{x, y}) <= std::max(limit, 0.0) + rounding_margin(box, point);
    };
    simulation.broad.search(may_contain, [&](std::uint32_t shape) {
        if (!is_included(simulation, shape, filter)) return;
        const DistanceResult gap =
            distance(simulation.shapes[shape].shape, pose_of(simulation, shape), probe, at_point);
        if (gap.status == DistanceStatus::invalid || gap.distance > limit) return;
        const ShapeId id = shape_id(simulation, shape);
        if (best && gap.distance == limit && best->shape < id) return;
        best = ClosestHit{id, body_id(simulation, shape), gap.distance, gap.point_a, gap.normal};
        limit = gap.distance;
    });
    return best;
}

BodyDistance find_distance(const Simulation& simulation, BodyId a, BodyId b) {
    std::vector<Shape> shapes[2];
    std::vector<ShapeId> ids[2];
    const BodyId bodies[2] = {a, b};
    for (int side = 0; side < 2; ++side)
        for (const ShapeId id : simulation.bodies.records[bodies[side].index].shapes)
            if (!simulation.shapes[id.index].is_sensor) {
                shapes[side].push_back(simulation.shapes[id.index].shape);
                ids[side].push_back(id);
            }
    const CompoundDistance found = compound_distance(shapes[0], simulation.bodies.frames[a.index].pose, shapes[1],
                                                     simulation.bodies.frames[b.index].pose);
    BodyDistance result{found.nearest, {}, {}};
    if (found.part_a < 0) return result;
    result.shape_a = ids[0][static_cast<std::size_t>(found.part_a)];
    result.shape_b = ids[1][static_cast<std::size_t>(found.part_b)];
    return result;
}

}  // namespace tumble
