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
#include "narrow/core_distance.hpp"
#include "narrow/witness.hpp"

namespace tumble {

namespace {

constexpr auto kUnobserved = [](const Simplex&, const Closest&, const MinkowskiSupport&) {};

class ImpactSearch {
public:
    ImpactSearch(const Motion& motion, double reach) : motion_(motion), reach_(reach) {}

    CastResult run(double radius_a, const Sweep& sweep_a) {
        for (steps_ = 1; steps_ <= kMaxImpactSteps; ++steps_) {
            measure();
            if (steps_ == 1 && gap_ < -motion_.error()) return overlapped(steps_);
            const SeparatingAxis axis = axis_of_features();
            const bool is_near = gap_ <= 2.0 * motion_.error();
            const double rate = is_near ? closing_rate(motion_, cores_, axis) : 0.0;
            if (rate > motion_.error()) return hit(radius_a, sweep_a, proved_contact(rate));
            fraction_ += step_along(axis, is_near);
            if (fraction_ >= 1.0) return missed(steps_);
        }
        return stopped(radius_a, sweep_a);
    }

private:
    void measure() {
        cores_ = motion_.at(fraction_);
        if (steps_ > 1 && is_at_target_by_cache()) return;
        core_ = measure_cores<VoronoiRegions>(cores_.pair, &cache_, kUnobserved);
        gap_ = core_.distance - reach_;
    }

    // The simplex of the last step bounds the distance from above, and from below the step has proved it: if this is the
    // target already, no support is needed.
    bool is_at_target_by_cache() {
        const CoreDistance bound = distance_of_cached_simplex(cores_.pair);
        if (!(bound.distance - reach_ <= 2.0 * motion_.error())) return false;
        core_ = bound;
        gap_ = bound.distance - reach_;
        return true;
    }

    // An upper bound on the core distance; infinite if the simplex holds the origin.
    CoreDistance distance_of_cached_simplex(const CorePair& pair) const {
        GjkResult last;
        last.simplex = simplex_of_cache(pair, cache_);
        last.closest = VoronoiRegions::reduce(pair, last.simplex);
        last.height = -last.closest.toward;
        if (!last.closest.contains_origin) return separated_cores(pair, last);
        CoreDistance unknown;
        unknown.distance = std::numeric_limits<double>::infinity();
        return unknown;
    }

    // The first fraction tried from here on at which the shapes are proved to be nearer than the target; 1 if none is.
    double proved_contact(double rate) const {
        for (double ahead = 4.0 * motion_.error() / rate; fraction_ + ahead < 1.0; ahead *= 8.0) {
            const CorePair pair = motion_.at(fraction_ + ahead).pair;
            SimplexCache cache = cache_;
            const double core_distance = measure_cores<VoronoiRegions>(pair, &cache, kUnobserved).distance;
            if (core_distance - reach_ <= -motion_.error()) return fraction_ + ahead;
        }
        return 1.0;
    }

    // The normal turns with the face that it belongs to; between two vertices it keeps its direction.
    SeparatingAxis axis_of_features() const {
        const VertexPair first = core_.pairs[0], second = core_.pairs[1];
        const bool has_edge = core_.pair_count == 2;
        const bool is_face_of_a = has_edge && first.b == second.b, is_face_of_b = has_edge && first.a == second.a;
        const double rate = is_face_of_a ? motion_.turn_a() : is_face_of_b ? motion_.turn_b() : 0.0;
        return {core_.normal, rate, first.a, first.b};
    }

    double step_along(const SeparatingAxis& axis, bool is_near) const {
        const double left = 1.0 - fraction_;
        const double gap = is_near ? std::max(0.0, gap_ + 3.0 * motion_.error()) : gap_ - motion_.error();
        const double apart = disc_step(axis.normal);
        if (apart >= left) return left;
        return std::max(apart, certified_step(motion_, cores_, axis, gap, left));
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
        result.point = center + ((witness.a - cores_.a.center) + radius_a * core_.normal);
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
