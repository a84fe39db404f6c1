// Casts of compounds: pairs of parts in the order of the fraction before which their boxes cannot touch.
#include <cstddef>
#include <limits>
#include <utility>

#include "debug/check.hpp"
#include "narrow/cast/cast_result.hpp"
#include "narrow/compound/part_pairs.hpp"
#include "tumble/compound.hpp"

namespace tumble {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// The first of all casts so far.
class FirstCast {
public:
    double limit() const { return is_decided_ ? -kInfinite : result_.first.fraction; }

    void add(const CastResult& found, std::int32_t part_a, std::int32_t part_b) {
        ++result_.queries;
        TUMBLE_CHECK(!(found.fraction < 0.0));
        TUMBLE_CHECK(!(found.fraction > 1.0));
        if (found.status == CastStatus::invalid) is_valid_ = false;
        if (is_decided_ || (found.status != CastStatus::hit && found.status != CastStatus::overlapping)) return;
        is_decided_ = found.status == CastStatus::overlapping;
        const bool is_first = result_.part_a < 0 || found.fraction < result_.first.fraction;
        const bool is_tie = found.fraction == result_.first.fraction &&
                            std::pair(part_a, part_b) < std::pair(result_.part_a, result_.part_b);
        if (!is_decided_ && !is_first && !is_tie) return;
        result_.first = found;
        result_.part_a = part_a;
        result_.part_b = part_b;
    }

    CompoundCast result() const {
        if (is_valid_) return result_;
        CompoundCast invalid;
        invalid.first = invalid_cast();
        return invalid;
    }

private:
    CompoundCast result_{missed(0), -1, -1, 0};
    bool is_decided_ = false;
    bool is_valid_ = true;
};

// The fraction at which two boxes first come within `margin` of each other along both axes, B moving by `motion`;
// infinite if they never do.
double first_touch_of_boxes(const Aabb& a, const Aabb& b, DVec2 motion, double margin) {
    double enter = 0.0, leave = kInfinite;
    TUMBLE_CHECK(margin >= 0.0);
    const auto cut = [&](double a_lower, double a_upper, double b_lower, double b_upper, double path) {
        const double from = (a_lower - margin) - b_upper,
                     to = (a_upper + margin) - b_lower;  // displacements of B at which they touch
        if (path == 0.0) {
            if (from > 0.0 || to < 0.0) leave = -kInfinite;
            return;
        }
        enter = std::max(enter, (path > 0.0 ? from : to) / path);
        leave = std::min(leave, (path > 0.0 ? to : from) / path);
    };
    cut(a.lower.x, a.upper.x, b.lower.x, b.upper.x, motion.x);
    cut(a.lower.y, a.upper.y, b.lower.y, b.upper.y, motion.y);
    return enter <= leave ? enter : kInfinite;
}

// The first hit of all pairs; casts only the pairs whose bound lies before it.
template <class Bound, class Cast>
CompoundCast find_first(PartPairs& pairs, Bound bound, Cast cast) {
    FirstCast first;
    if (!pairs.are_valid()) {
        first.add(invalid_cast(), 0, 0);
        return first.result();
    }
    pairs.visit(
        bound, [&] { return first.limit(); },
        [&](std::int32_t i, std::int32_t k) {
            first.add(cast(static_cast<std::size_t>(i), static_cast<std::size_t>(k)), i, k);
        });
    return first.result();
}

// The distance of the farthest point of any part from the centre of mass, for its speed by turning.
double farthest(std::span<const Shape> parts, Vec2 center) {
    double result = 0.0;
    for (const Shape& part : parts) result = std::max<double>(result, farthest_distance(part, center));
    return result;
}

}  // namespace

CompoundCast compound_cast_ray(std::span<const Shape> parts, const Pose& world_from_parts, DVec2 origin,
                               DVec2 translation) {
    const Shape point[] = {make_circle(0.0f)};
    PartPairs pairs(parts, world_from_parts, point, {origin, {}});
    const double margin = pairs.rounding();
    if (!is_valid_motion(translation)) return {invalid_cast(), -1, -1, 0};
    return find_first(
        pairs, [&](const Aabb& a, const Aabb& b) { return first_touch_of_boxes(a, b, translation, margin); },
        [&](std::size_t i, std::size_t) { return cast_ray(parts[i], world_from_parts, origin, translation); });
}

CompoundCast compound_cast_shape(std::span<const Shape> a, const Pose& world_from_a, std::span<const Shape> b,
                                 const Pose& world_from_b, DVec2 translation, double target) {
    PartPairs pairs(a, world_from_a, b, world_from_b);
    if (!is_valid_motion(translation) || !(target >= 0.0)) return {invalid_cast(), -1, -1, 0};
    const double margin = target + pairs.rounding(target);
    return find_first(
        pairs,
        [&](const Aabb& box_a, const Aabb& box_b) { return first_touch_of_boxes(box_a, box_b, translation, margin); },
        [&](std::size_t i, std::size_t k) {
            return cast_shape(a[i], world_from_a, b[k], world_from_b, translation, target);
        });
}

// No distance shrinks faster than the bodies' farthest points approach. The start's rotations are rounded to float
// here.
CompoundCast compound_time_of_impact(std::span<const Shape> a, const Sweep& sweep_a, std::span<const Shape> b,
                                     const Sweep& sweep_b, double target) {
    PartPairs pairs(a, pose_at(sweep_a, 0.0), b, pose_at(sweep_b, 0.0));
    if (!(target >= 0.0)) return {invalid_cast(), -1, -1, 0};
    const DVec2 velocity = (sweep_b.end - sweep_b.start) - (sweep_a.end - sweep_a.start);
    const double speed = (length(velocity) + std::abs(sweep_a.turn) * farthest(a, sweep_a.local_center) +
                          std::abs(sweep_b.turn) * farthest(b, sweep_b.local_center)) *
                         (1.0 + 0x1p-40);
    TUMBLE_CHECK(!(speed < 0.0));
    const double margin = target + 0x1p-20 * (pairs.sizes() + target);
    return find_first(
        pairs,
        [&](const Aabb& box_a, const Aabb& box_b) {
            const double gap = separation(box_a, box_b) - margin;
            return gap > 0.0 ? gap / speed : 0.0;
        },
        [&](std::size_t i, std::size_t k) { return time_of_impact(a[i], sweep_a, b[k], sweep_b, target); });
}

}  // namespace tumble
