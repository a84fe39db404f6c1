// The truth about two moving shapes, in long double (64-bit mantissa on x86-64, 2^11 times finer than what it judges):
// the distance at a fraction by looking at every vertex and edge; along a translation, when it falls to a floor in
// closed form; with rotation, by halving intervals until the speed of the shapes forbids it in each.
#pragma once

#include <optional>
#include <vector>

#include "reference/exact/brute_distance.hpp"
#include "reference/query/cast_query.hpp"

namespace tumble::reference {

class TrueMotion {
public:
    using Real = brute::Real;

    explicit TrueMotion(const CastQuery& query);

    // Signed distance less the target.
    Real gap(Real fraction) const;

    // E: the bound that tumble states for its own errors.
    double error() const { return error_; }

    // Of bodies that do not turn and start apart: the first fraction at which the gap is 0, none if it stays above.
    bool is_straight() const { return a_.turn == 0 && b_.turn == 0; }
    std::optional<Real> first_contact() const { return first_within(reach_, 0); }

    // True if the gap is at least `floor` all over [from, to].
    bool stays_above(Real floor, Real from, Real to) const;

private:
    // A body in axes that do not turn, relative to A's centre at the start.
    struct Body {
        std::vector<brute::Point> vertices;  // from the centre, unturned
        brute::Point start{}, way{};
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
    Real speed_;  // no point moves faster relative to one of the other shape, m a whole motion
    double error_;
};

}  // namespace tumble::reference
