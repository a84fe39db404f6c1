// The certificate checker: verifies in exact arithmetic that the certificate of an answer proves its bounds. It uses no
// code of the narrow phase.
//
// Lower bound: with h the maximum of direction . w over the Minkowski difference, the signed core distance is at least
// -h / |direction|, for any direction. O(n + m).
// Upper bound, separated cores: the core distance is at most that of the claimed segment (or point) of the Minkowski
// difference from the origin. O(1).
// Upper bound, overlapping cores: some face attains the depth, so that all faces are evaluated (find_deepest_face()
// states the cost). The claimed pairs must also span a face whose separation is within the bounds. The radii are added
// to the bounds exactly, and squares are compared. Intervals of long double decide most of these inequalities, exact
// arithmetic the others (INTERVALS.md).
#pragma once

#include "reference/exact/interval_pair.hpp"
#include "reference/query/pair_query.hpp"
#include "tumble/distance.hpp"

namespace tumble::reference {

enum class CertificateVerdict {
    accepted,
    malformed,  // no or too many pairs, an index out of range, a direction that is zero, a number that is not finite
    lower_not_proved,
    upper_not_proved,
    face_not_proved,    // overlapping: the claimed pairs span no face, or one whose separation is outside the bounds
    status_not_proved,  // the status does not follow from the bounds
};

const char* to_string(CertificateVerdict verdict);

// The query must be finite, and the result not `invalid`. The verdict does not depend on the arithmetic.
CertificateVerdict check_certificate(const PairQuery& query, const DistanceResult& result,
                                     Arithmetic arithmetic = Arithmetic::intervals_first);

}  // namespace tumble::reference
