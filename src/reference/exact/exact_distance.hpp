// The oracle: the exact signed distance of two shapes, by looking at everything.
//
// Overlap and depth come from the separations along all face normals (separating axes), the distance of separated cores
// from all pairs of a vertex and an edge; nothing is shared with the narrow phase, and nothing is rounded. Cores that
// are points or segments, repeated and collinear vertices need no special case. 10 to 16 us for two boxes, O(n m)
// rational comparisons: for more than 64 vertices check the certificate of an answer instead (certificate.hpp).
#pragma once

#include "reference/exact/exact_number.hpp"
#include "reference/query/pair_query.hpp"

namespace tumble::reference {

class ExactDistance {
public:
    // The query must be finite.
    explicit ExactDistance(const PairQuery& query);

    // The sign of the exact signed distance minus x; of the signed distance itself for x = 0.
    int compare(double x) const;
    int sign() const { return compare(0.0); }

    // The exact signed distance minus x, and the distance itself, correctly rounded (as rounded_difference() says).
    double minus(double x) const;
    double value() const { return minus(0.0); }

    // The same cores with other radii (m).
    ExactDistance with_radii(double radius_a, double radius_b) const;

    // True if a single pair of points is closest: separated cores, except edges that are exactly parallel and face
    // each other.
    bool has_unique_pair() const { return unique_pair_; }

private:
    SignedRoot core_;  // signed distance of the cores
    double radius_a_ = 0.0, radius_b_ = 0.0;
    bool unique_pair_ = false;
};

}  // namespace tumble::reference
