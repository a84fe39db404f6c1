// The exact oracle: the signed distance of two shapes by exhaustive search, without rounding.
//
// Overlap and depth are found by the separations along all face normals (separating axes), the distance of separated
// cores by all pairs of a vertex and an edge. No code is shared with the narrow phase. Points, segments, repeated and
// collinear vertices need no special case. O(n m) exact comparisons, 10 to 16 us for two boxes. For more than 64
// vertices check the certificate of an answer instead (certificate.hpp).
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

    // The exact signed distance minus x, and the distance itself, rounded as rounded_difference() states.
    double minus(double x) const;
    double value() const { return minus(0.0); }

    // The same cores with other radii (m).
    ExactDistance with_radii(double radius_a, double radius_b) const;

    // True if exactly one pair of points is closest: the cores are separated, and no two parallel edges face each
    // other.
    bool has_unique_pair() const { return unique_pair_; }

private:
    SignedRoot core_;  // signed distance of the cores
    double radius_a_ = 0.0, radius_b_ = 0.0;
    bool unique_pair_ = false;
};

}  // namespace tumble::reference
