// The checker: does the certificate of an answer prove its bounds? In rationals, trusting nothing of the narrow phase.
//
// lower: with h the maximum of direction . w over the Minkowski difference, the signed core distance is at least
// -h / |direction|, for any direction; O(n + m). upper, separated: the core distance is at most that of the one or two
// claimed pairs from the origin; O(1). upper, overlapping: the depth is attained at some face, so all are looked at
// (find_deepest_face() says the cost); and the claimed pairs must span a face that lies within the bounds themselves.
// Bounds are compared with the radii moved to the exact side, by squares.
#pragma once

#include "reference/query/pair_query.hpp"
#include "tumble/distance.hpp"

namespace tumble::reference {

enum class CertificateVerdict {
    accepted,
    malformed,  // no or too many pairs, an index out of range, a direction or a bound that is not finite, or zero
    lower_not_proved,
    upper_not_proved,
    face_not_proved,    // overlapping: the claimed pairs span no face, or one whose separation is outside the bounds
    status_not_proved,  // the bounds do not say what the status says
};

const char* to_string(CertificateVerdict verdict);

// The query must be finite, and the result not `invalid`.
CertificateVerdict check_certificate(const PairQuery& query, const DistanceResult& result);

}  // namespace tumble::reference
