// Time of impact: conservative advancement in certified steps [Mirtich 1996], of second order where one vertex or face
// leads.
//
// Each step measures the distance, takes the axis of the closest features and goes on for as long as the separation along
// it is proved to stay above the target. Steps aim at a gap of E, so that what lies behind is proved free in exact
// arithmetic. At a gap below 2 E the motion either closes, which is the hit, or it slides, recedes or turns away: then the
// step may spend 3 E of the 4 E that are allowed, and the search goes on.
#include <algorithm>
#include <limits>

#include "narrow/cast_result.hpp"
#include "narrow/certified_step.hpp"
#include "narrow/leading_features.hpp"
#include "narrow/measure_cores.hpp"
#include "narrow/witness.hpp"

namespace tumble {

namespace {

constexpr auto kKeep = [](const CoreDistance& found) { return found; };

class ImpactSearch {
public:
    ImpactSearch(const Motion& motion, double reach) : motion_(motion), reach_(reach) {}

    CastResult run(double radius_a, const Sweep& sweep_a) {
        for (steps_ = 1; steps_ <= kMaxImpactSteps; ++steps_) {
            measure();
            if (steps_ == 1 && gap_ < -motion_.error()) return overlapped(steps_);
            const bool is_near = gap_ <= 2.0 * motion_.error();
            if (is_near && closes(motion_, cores_, axis_)) return hit(radius_a, sweep_a, proved_contact());
            fraction_ += step(is_near);
            if (fraction_ >= 1.0) return missed(steps_);
        }
        return stopped(radius_a, sweep_a);
    }

private:
    // Far apart, the line of the centres is an axis that costs two supports. Nearer, the features of the last step lead,
    // as long as they are proved to be the closest; at the target an upper bound is enough, as the step that came here is
    // the lower one. Else GJK.
    void measure() {
        cores_ = motion_.at(fraction_);
        if (steps_ == 1 && is_far_along_centers()) return;
        const LedDistance led = distance_of_simplex(cores_.pair, cache_);
        const bool is_at_target = led.core.distance - reach_ <= 2.0 * motion_.error();
        if (led.exists && (led.is_proved || is_at_target)) {
            core_ = led.core;
        } else {
            core_ = measure_cores(cores_.pair, &cache_, kKeep);
        }
        gap_ = core_.distance - reach_;
        axis_ = axis_of_features();
    }

    bool is_far_along_centers() {
        constexpr double kFar = 0.25;  // of the distance of the centres
        const double apart = length(cores_.separation);
        if (!(apart - reach_ > kFar * apart)) return false;
        const DVec2 normal = (1.0 / apart) * cores_.separation;
        const Support a = support(cores_.pair.a, normal), b = support(cores_.pair.b, -normal);
        gap_ = (dot(normal, cores_.pair.offset) - (a.height + b.height)) - reach_;
        axis_ = {normal, 0.0, a.index, b.index};
        return gap_ > kFar * apart;
    }

    // A fraction from here on at which the shapes are proved to be nearer than the target; 1 if none is found.
    double proved_contact() const {
        const double rate = closing_rate(motion_, cores_, axis_);
        double ahead = 4.0 * motion_.error() / std::max(rate, motion_.error());
        if (fraction_ + ahead < 1.0 && rate > motion_.error() && is_led_by_features(ahead)) return fraction_ + ahead;
        for (; fraction_ + ahead < 1.0; ahead *= 8.0) {
            const CorePair pair = motion_.at(fraction_ + ahead).pair;
            SimplexCache cache = cache_;
            const double core_distance = measure_cores(pair, &cache, kKeep).distance;
            if (core_distance - reach_ <= -motion_.error()) return fraction_ + ahead;
        }
        return 1.0;
    }

    // True if until then the closest features stay a vertex and the inside of an edge, or two vertices, and their approach
    // does not slow down by more than E / 2: their distance bounds that of the shapes from above.
    bool is_led_by_features(double ahead) const {
        const double turns = std::abs(motion_.turn_a()) + std::abs(motion_.turn_b()), way = length(motion_.velocity());
        const double extents = motion_.extent_a() + motion_.extent_b();
        const double speed = way + turns * extents;
        double bend = turns * (0.5 * turns * (extents + length(cores_.separation)) + way);
        const VertexPair first = core_.pairs[0], second = core_.pairs[1];
        if (core_.pair_count == 1) {
            bend += speed * speed / core_.distance;
        } else {
            const bool is_rigid = first.a == second.a || first.b == second.b;
            const DVec2 from = minkowski_vertex(cores_.pair, first).w, to = minkowski_vertex(cores_.pair, second).w;
            const double margin = 2.0 * (speed * ahead + motion_.error()) * length(to - from);
            if (!is_rigid || -dot(from, to - from) < margin || dot(to, to - from) < margin) return false;
        }
        return bend * ahead * ahead <= 0.5 * motion_.error();
    }

    // The normal turns with the face that it belongs to; between two vertices it keeps its direction.
    SeparatingAxis axis_of_features() const {
        const VertexPair first = core_.pairs[0], second = core_.pairs[1];
        const bool has_edge = core_.pair_count == 2;
        const bool is_face_of_a = has_edge && first.b == second.b, is_face_of_b = has_edge && first.a == second.a;
        const double rate = is_face_of_a ? motion_.turn_a() : is_face_of_b ? motion_.turn_b() : 0.0;
        return {core_.normal, rate, first.a, first.b};
    }

    double step(bool is_near) const {
        const double left = 1.0 - fraction_;
        const double gap = is_near ? std::max(0.0, gap_ + 3.0 * motion_.error()) : gap_ - motion_.error();
        const double apart = disc_step(axis_.normal);
        if (apart >= left) return left;
        return std::max(apart, certified_step(motion_, cores_, axis_, gap, left));
    }

    // Whatever they turn, the cores stay within discs around their centres of mass.
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
        result.normal = core_.normal;
        const CoreWitness witness = core_witness(cores_.pair, core_);
        const DVec2 center = sweep_a.start + fraction_ * (sweep_a.end - sweep_a.start);
        result.point = center + ((witness.a - cores_.center_a) + radius_a * core_.normal);
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
    CoreDistance core_;
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
    return ImpactSearch(motion, reach).run(radius_a, sweep_a);
}

Pose pose_at(const Sweep& sweep, double fraction) {
    const Rotation rotation = make_rotation(sweep.start_angle + fraction * sweep.turn);
    const DVec2 center = sweep.start + fraction * (sweep.end - sweep.start);
    return {center - rotate(rotation, DVec2(sweep.local_center)), rotation};
}

}  // namespace tumble
