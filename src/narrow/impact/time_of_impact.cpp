// Time of impact: conservative advancement [Mirtich 1996] in certified steps (CERTIFIED_STEP.md).
//
// Each step measures the distance, takes the axis of the closest features and advances as far as the separation along
// it is proved to stay above the target. Steps aim at a gap of E, so that the part of the motion behind them is proved
// free in exact arithmetic. At a gap of at most 2 E the motion either closes, which is the hit, or slides, recedes or
// turns away: then the step may use 3 E of the 4 E that are allowed, and the search continues.
#include <algorithm>
#include <limits>

#include "debug/check.hpp"
#include "narrow/cast/cast_result.hpp"
#include "narrow/distance/measure_cores.hpp"
#include "narrow/distance/witness.hpp"
#include "narrow/impact/certified_step.hpp"
#include "narrow/impact/disc_impact.hpp"
#include "narrow/impact/leading_features.hpp"

namespace tumble {

namespace {

constexpr auto kDistance = [](const CoreDistance& found) { return found.distance; };

class ImpactSearch {
public:
    ImpactSearch(const Motion& motion, double reach) : motion_(motion), reach_(reach), cores_(motion.at(0.0)) {}

    CastResult run(double radius_a, const Sweep& sweep_a) {
        for (steps_ = 1; steps_ <= kMaxImpactSteps; ++steps_) {
            measure();
            if (steps_ == 1 && gap_ < -motion_.error()) return overlapped(steps_);
            const bool is_near = gap_ <= 2.0 * motion_.error();
            if (is_near) {
                const Closing closing = closing_along(motion_, cores_, axis_);
                if (closing.is_proved) return hit(radius_a, sweep_a, proved_contact(closing.rate));
            }
            const double advance = step(is_near);
            TUMBLE_CHECK(!(advance < 0.0));
            fraction_ += advance;
            if (fraction_ >= 1.0) return missed(steps_);
        }
        return stopped(radius_a, sweep_a);
    }

private:
    // Far apart, the line of the centres is an axis that costs two supports. Nearer, the features of the last step are
    // used as long as they are proved to be the closest; at the target their upper bound is enough, as the step to here
    // proved the lower one. Otherwise the closest features are searched.
    void measure() {
        TUMBLE_CHECK(fraction_ >= 0.0);
        TUMBLE_CHECK(fraction_ < 1.0);
        if (steps_ > 1) motion_.move(cores_, fraction_);
        if (steps_ == 1 && is_far_along_centers()) return;
        if (!follow(cores_.pair, feature_) && !is_at_target()) search();
        gap_ = feature_.distance - reach_;
        take_axis_of_feature();
    }

    bool is_at_target() const {
        return feature_.kind == LeadingFeature::Kind::vertices && feature_.distance - reach_ <= 2.0 * motion_.error();
    }

    void search() {
        const CorePair& pair = cores_.pair;
        const bool is_large =
            pair.a.large || pair.b.large;  // a search of small cores is so short that a cache does not pay
        measure_cores(pair, is_large ? &cache_ : nullptr,
                      [&](const CoreDistance& found) { take(feature_, pair, found); });
    }

    bool is_far_along_centers() {
        constexpr double kFar = 0.5;  // of the distance of the centres
        const double apart = length(cores_.separation);
        if (!(apart - reach_ > kFar * apart)) return false;
        const DVec2 normal = (1.0 / apart) * cores_.separation;
        const Support a = support(cores_.pair.a, normal), b = support(cores_.pair.b, -normal);
        gap_ = (dot(normal, cores_.pair.offset) - (a.height + b.height)) - reach_;
        set_axis(normal, 0.0, a.index, b.index, -1);
        return gap_ > kFar * apart;
    }

    // A fraction from here on at which the shapes are proved to be nearer than the target; 1 if none is found.
    double proved_contact(double rate) const {
        double ahead = 4.0 * motion_.error() / std::max(rate, motion_.error());
        if (fraction_ + ahead < 1.0 && rate > motion_.error() && is_led_by_feature(ahead)) return fraction_ + ahead;
        for (; fraction_ + ahead < 1.0; ahead *= 8.0) {
            const CorePair pair = motion_.at(fraction_ + ahead).pair;
            if (measure_cores(pair, nullptr, kDistance) - reach_ <= -motion_.error()) return fraction_ + ahead;
        }
        return 1.0;
    }

    // True if from here to `ahead` the closest features stay a vertex and the inside of an edge, or two vertices, and
    // their approach slows down by at most E / 2: their distance is then an upper bound for that of the shapes.
    bool is_led_by_feature(double ahead) const {
        const auto above_length = [](DVec2 v) { return std::abs(v.x) + std::abs(v.y); };
        const double turns = std::abs(motion_.turn_a()) + std::abs(motion_.turn_b()),
                     path = above_length(motion_.velocity());
        const double extents = motion_.extent_a() + motion_.extent_b();
        const double speed = path + turns * extents;
        double bend = turns * (0.5 * turns * (extents + above_length(cores_.separation)) + path);
        if (feature_.kind == LeadingFeature::Kind::none) return false;
        if (feature_.kind == LeadingFeature::Kind::vertices) {
            bend += speed * speed / feature_.distance;
        } else {
            const DVec2 from = minkowski_vertex(cores_.pair, feature_.pairs[0]).w,
                        to = minkowski_vertex(cores_.pair, feature_.pairs[1]).w;
            const double margin = 2.0 * (speed * ahead + motion_.error()) * above_length(to - from);
            if (-dot(from, to - from) < margin || dot(to, to - from) < margin) return false;
        }
        return bend * ahead * ahead <= 0.5 * motion_.error();
    }

    // The normal turns with the face that it belongs to; between two vertices it keeps its direction.
    void take_axis_of_feature() {
        const VertexPair at = feature_.pairs[0];
        const bool is_face = feature_.kind == LeadingFeature::Kind::face;
        const double rates[2] = {motion_.turn_a(), motion_.turn_b()};
        set_axis(feature_.normal, is_face ? rates[feature_.owner] : 0.0, at.a, at.b,
                 is_face ? static_cast<int>(feature_.owner) : -1);
    }

    void set_axis(DVec2 normal, double rate, int support_a, int support_b, int owner) {
        TUMBLE_CHECK(support_a < cores_.pair.a.count);
        TUMBLE_CHECK(support_b < cores_.pair.b.count);
        TUMBLE_CHECK(owner < 2);
        axis_.normal.x = normal.x;
        axis_.normal.y = normal.y;
        axis_.rate = rate;
        axis_.supports[0] = support_a;
        axis_.supports[1] = support_b;
        axis_.owner = owner;
    }

    double step(bool is_near) const {
        const double left = 1.0 - fraction_;
        const double gap = is_near ? std::max(0.0, gap_ + 3.0 * motion_.error()) : gap_ - motion_.error();
        const double apart = disc_step(axis_.normal);
        if (apart >= left) return left;
        return std::max(apart, certified_step(motion_, cores_, axis_, gap, left));
    }

    // However they turn, the cores stay within discs around their centres of mass.
    double disc_step(DVec2 normal) const {
        const double extents = motion_.extent_a() + motion_.extent_b();
        const double gap = (dot(normal, cores_.separation) - extents) - reach_ - motion_.error();
        if (gap <= 0.0) return 0.0;
        const double closing = -dot(normal, motion_.velocity());
        return closing > 0.0 ? gap / closing : std::numeric_limits<double>::infinity();
    }

    CastResult hit(double radius_a, const Sweep& sweep_a, double upper) const {
        CastResult result;
        result.status = CastStatus::hit;
        result.fraction = result.lower = fraction_;
        result.upper = upper;
        TUMBLE_CHECK(fraction_ < 1.0);
        TUMBLE_CHECK(fraction_ <= upper);
        result.normal = feature_.normal;
        CoreDistance core;
        core.distance = feature_.distance;
        core.normal = feature_.normal;
        core.pairs[0] = feature_.pairs[0];
        core.pairs[1] = feature_.pairs[1];
        core.pair_count = feature_.kind == LeadingFeature::Kind::vertices ? 1 : 2;
        const CoreWitness witness = core_witness(cores_.pair, core);
        const DVec2 center = sweep_a.start + fraction_ * (sweep_a.end - sweep_a.start);
        result.point = center + ((witness.a - cores_.center_a) + radius_a * feature_.normal);
        result.iterations = steps_;
        return result;
    }

    CastResult stopped(double radius_a, const Sweep& sweep_a) const {
        CastResult result = hit(radius_a, sweep_a, 1.0);
        result.reached_cap = true;
        return result;
    }

    const Motion& motion_;
    double reach_;
    double fraction_ = 0.0;
    MovingCores cores_{};
    LeadingFeature feature_;
    SimplexCache cache_;
    SeparatingAxis axis_{};
    double gap_ = 0.0;
    std::int32_t steps_ = 0;
};

}  // namespace

CastResult time_of_impact(const Shape& a, const Sweep& sweep_a, const Shape& b, const Sweep& sweep_b,
                          double target) noexcept {
    const double radius_a = a.radius(), reach = (radius_a + b.radius()) + target;
    const Motion motion(a, sweep_a, b, sweep_b, reach);
    if (!motion.is_valid() || !(target >= 0.0)) return invalid_cast();
    if (is_centered_disc(a, sweep_a) && is_centered_disc(b, sweep_b))
        if (const std::optional<CastResult> found = find_disc_impact(motion, reach, radius_a, sweep_a)) return *found;
    return ImpactSearch(motion, reach).run(radius_a, sweep_a);
}

Pose pose_at(const Sweep& sweep, double fraction) {
    const Rotation rotation = make_rotation(sweep.start_angle + fraction * sweep.turn);
    const DVec2 center = sweep.start + fraction * (sweep.end - sweep.start);
    return {center - rotate(rotation, DVec2(sweep.local_center)), rotation};
}

}  // namespace tumble
