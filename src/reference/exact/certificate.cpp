#include "reference/exact/certificate.hpp"

#include <algorithm>
#include <cmath>

#include "reference/exact/exact_geometry.hpp"

namespace tumble::reference {

namespace {

// The claimed bounds of the signed core distance: those of the answer plus the radii.
struct CoreBounds {
    ExactDyadic lower, upper;
};

bool is_well_formed(const PairQuery& query, const DistanceResult& result) {
    const Certificate& certificate = result.certificate;
    if (certificate.pair_count < 1 || certificate.pair_count > 2) return false;
    for (int i = 0; i < certificate.pair_count; ++i) {
        const VertexPair pair = certificate.pairs[static_cast<std::size_t>(i)];
        if (pair.a >= query.a.vertex_count() || pair.b >= query.b.vertex_count()) return false;
    }
    return is_finite(certificate.direction) && certificate.direction != DVec2{} && std::isfinite(result.lower) &&
           std::isfinite(result.upper);
}

bool is_status_proved(const DistanceResult& result) {
    switch (result.status) {
        case DistanceStatus::separated: return result.lower > 0.0;
        case DistanceStatus::overlapping: return result.upper < 0.0;
        case DistanceStatus::touching: return result.lower <= 0.0 && result.upper >= 0.0;
        case DistanceStatus::invalid: break;
    }
    return false;
}

ExactPoint exact_direction(DVec2 direction) {
    const int exponent = std::min(lowest_bit_exponent(direction.x), lowest_bit_exponent(direction.y));
    return {scaled(direction.x, exponent), scaled(direction.y, exponent)};
}

// The separation along that normal of the claimed face that points in the claimed direction. For a face of one point,
// the negative distance of the point from the origin.
SignedRoot face_separation(const ExactPair& pair, const ExactPoint& w1, const ExactPoint& w2,
                           const ExactPoint& direction) {
    const ExactPoint edge = w2 - w1;
    if (is_zero(edge)) {
        SignedRoot distance = segment_distance(pair, w1, w2);
        distance.sign = -distance.sign;
        return distance;
    }
    const mpz_class along = direction.x * edge.y - direction.y * edge.x;  // direction . (edge.y, -edge.x)
    const int side = along < 0 ? -1 : 1;
    const mpz_class value = side * (w1.y * edge.x - w1.x * edge.y);
    return {sgn(value), value * value, edge.x * edge.x + edge.y * edge.y, pair.exponent};
}

CertificateVerdict check_overlapping_upper(const ExactPair& pair, const ExactPoint& w1, const ExactPoint& w2,
                                           const ExactPoint& direction, const CoreBounds& bounds) {
    const SignedRoot face = face_separation(pair, w1, w2, direction);
    if (compare(face, bounds.lower) < 0 || compare(face, bounds.upper) > 0) return CertificateVerdict::face_not_proved;
    SignedRoot deepest;
    const bool has_faces = find_deepest_face(pair, deepest, false);
    // If the largest separation is negative, it is the signed distance. Otherwise the cores are separated, by less than
    // the rounding that the bounds allow for, and the distance of the claimed segment must be within the bound.
    const bool overlap = has_faces && deepest.sign < 0;
    const SignedRoot& attained = overlap ? deepest : segment_distance(pair, w1, w2);
    return compare(attained, bounds.upper) <= 0 ? CertificateVerdict::accepted : CertificateVerdict::upper_not_proved;
}

}  // namespace

const char* to_string(CertificateVerdict verdict) {
    switch (verdict) {
        case CertificateVerdict::accepted: return "accepted";
        case CertificateVerdict::malformed: return "malformed";
        case CertificateVerdict::lower_not_proved: return "lower bound not proved";
        case CertificateVerdict::upper_not_proved: return "upper bound not proved";
        case CertificateVerdict::face_not_proved: return "claimed face outside the bounds";
        case CertificateVerdict::status_not_proved: return "status contradicts the bounds";
    }
    return "unknown";
}

CertificateVerdict check_certificate(const PairQuery& query, const DistanceResult& result) {
    if (!is_well_formed(query, result)) return CertificateVerdict::malformed;
    if (!is_status_proved(result)) return CertificateVerdict::status_not_proved;
    const ExactPair pair = exact_pair(query);
    const double radius_a = query.a.radius(), radius_b = query.b.radius();
    const CoreBounds bounds{exact_sum({result.lower, radius_a, radius_b}),
                            exact_sum({result.upper, radius_a, radius_b})};

    const ExactPoint direction = exact_direction(result.certificate.direction);
    if (compare(separation(pair, direction), bounds.lower) < 0) return CertificateVerdict::lower_not_proved;

    const ExactPoint w1 = minkowski_vertex(pair, result.certificate.pairs[0]);
    const ExactPoint w2 =
        minkowski_vertex(pair, result.certificate.pairs[static_cast<std::size_t>(result.certificate.pair_count - 1)]);
    if (result.certificate.cores_overlap) return check_overlapping_upper(pair, w1, w2, direction, bounds);
    return compare(segment_distance(pair, w1, w2), bounds.upper) <= 0 ? CertificateVerdict::accepted
                                                                      : CertificateVerdict::upper_not_proved;
}

}  // namespace tumble::reference
