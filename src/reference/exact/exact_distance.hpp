// The exact oracle: the signed distance of two shapes, without rounding.
//
// Overlap and depth are found by the separations along all face normals (separating axes), the distance of separated
// cores by all pairs of a vertex and an edge. Intervals of long double decide most comparisons, and leave a few
// candidates to exact arithmetic where they do not (INTERVALS.md). No code is shared with the narrow phase. Points,
// segments, repeated and collinear vertices need no special case. O(n m); for two boxes 1 us, 6 us with exact
// arithmetic. For more than 64 vertices check the certificate of an answer instead (certificate.hpp).
#pragma once

#include <memory>

#include "reference/exact/interval_pair.hpp"
#include "reference/query/pair_query.hpp"

namespace tumble::reference {

// Copies share what they have computed: use them in one thread at a time.
class ExactDistance {
public:
    // The query must be finite. The results do not depend on the arithmetic.
    explicit ExactDistance(const PairQuery& query, Arithmetic arithmetic = Arithmetic::intervals_first);

    // The sign of the exact signed distance minus (x + offset), the sum not rounded; of the signed distance itself for
    // x = 0.
    int compare(double x, double offset = 0.0) const;
    int sign() const { return compare(0.0); }

    // The exact signed distance minus x, and the distance itself, rounded as rounded_difference() states.
    double minus(double x) const;
    double value() const { return minus(0.0); }

    // The same cores with other radii (m).
    ExactDistance with_radii(double radius_a, double radius_b) const;

    // True if exactly one pair of points is closest: the cores are separated, and no two parallel edges face each
    // other.
    bool has_unique_pair() const;

private:
    class Cores;
    std::shared_ptr<Cores> cores_;
    double radius_a_ = 0.0, radius_b_ = 0.0;
};

}  // namespace tumble::reference
