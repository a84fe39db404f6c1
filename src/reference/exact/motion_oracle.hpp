// The oracle for two moving shapes, in long double (64-bit mantissa on x86-64), hence 2^11 times finer than the narrow
// phase.
//
// The distance at a fraction of the motion comes from all vertices and edges. Along a translation, the fraction at
// which the distance reaches a floor has a closed form. With rotation, intervals are halved until the speed of the
// shapes proves that the distance stays above the floor in each.
#pragma once

#include <optional>
#include <vector>

#include "reference/exact/brute_distance.hpp"
#include "reference/query/cast_query.hpp"

namespace tumble::reference {

class MotionOracle {
public:
    using Real = brute::Real;

    explicit MotionOracle(const CastQuery& query);

    // The signed distance minus the target.
    Real gap(Real fraction) const;

    // E: the error bound that tumble states.
    double error() const { return error_; }

    bool is_straight() const { return a_.turn == 0 && b_.turn == 0; }

    // The first fraction at which the gap is 0; none if it stays positive. The motion must be straight, and the gap at
    // fraction 0 positive.
    std::optional<Real> first_contact() const { return first_within(reach_, 0); }

    // True if the gap is at least `floor` everywhere in [from, to].
    bool stays_above(Real floor, Real from, Real to) const;

private:
    // A body in world axes, relative to A's centre at the start.
    struct Body {
        std::vector<brute::Point> vertices;  // from the centre, at angle 0 if the body turns
        brute::Point start{}, displacement{};
        Real angle = 0, turn = 0;
        Real extent = 0;

        std::vector<brute::Point> at(Real fraction) const;
    };

    static Body body_of(const Shape& shape, const Pose& pose, DVec2 origin);
    static Body body_of(const Shape& shape, const Sweep& sweep, DVec2 origin);
    Real smallest_gap(Real from, Real to) const;
    bool stays_above_by_speed(Real floor, Real from, Real to) const;
    std::optional<Real> first_within(Real reach, Real from) const;

    Body a_, b_;
    Real reach_;
    Real speed_;  // upper bound on the relative speed of any two points, m per whole motion
    double error_;
};

}  // namespace tumble::reference
