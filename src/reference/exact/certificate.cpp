#include "reference/exact/certificate.hpp"

#include <cmath>
#include <optional>
#include <vector>

#include "reference/exact/candidates.hpp"
#include "reference/exact/exact_geometry.hpp"

namespace tumble::reference {

namespace {

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

// The inequalities of a certificate. Each function returns the sign of a signed core distance minus a claimed bound
// (m), to which the radii are added.
class Inequalities {
public:
    Inequalities(const PairQuery& query, const Certificate& claim, Arithmetic arithmetic)
        : query_(query), claim_(claim), intervals_(query, arithmetic) {}

    int compare_separation(double bound) {
        return compare(intervals_.separation(claim_.direction), bound,
                       [&] { return separation(pair(), exact_direction(claim_.direction)); });
    }

    int compare_claimed_segment(double bound) {
        return compare(intervals_.segment_distance(from(), to()), bound, [&] { return claimed_segment(); });
    }

    int compare_claimed_face(double bound) {
        return compare(intervals_.face_separation(from(), to(), claim_.direction), bound, [&] {
            return claimed_face_separation(pair(), minkowski_vertex(pair(), from()), minkowski_vertex(pair(), to()),
                                           exact_direction(claim_.direction));
        });
    }

    // Of the deepest face. If its separation is not negative, the cores are separated, by less than the rounding that
    // the bounds allow for, and the distance of the claimed segment must be within the bound.
    int compare_depth(double bound) {
        const std::vector<EstimatedFace> faces = intervals_.faces();
        const Interval deepest = faces.empty() ? Interval{} : largest_separation(faces);
        return compare(deepest.high < 0 ? deepest : Interval{}, bound, [&] {
            SignedRoot depth;
            return find_deepest_face(pair(), depth) && depth.sign < 0 ? depth : claimed_segment();
        });
    }

private:
    VertexPair from() const { return claim_.pairs[0]; }
    VertexPair to() const { return claim_.pairs[static_cast<std::size_t>(claim_.pair_count - 1)]; }

    const ExactPair& pair() {
        if (!exact_) exact_ = exact_pair(query_);
        return *exact_;
    }

    SignedRoot claimed_segment() {
        return segment_distance(pair(), minkowski_vertex(pair(), from()), minkowski_vertex(pair(), to()));
    }

    template <class Exact>
    int compare(Interval interval, double bound, Exact exact) const {
        const std::initializer_list<double> summands{bound, query_.a.radius(), query_.b.radius()};
        if (const auto sign = reference::compare(interval, interval_sum(summands))) return *sign;
        return reference::compare(exact(), exact_sum(summands));
    }

    const PairQuery& query_;
    const Certificate& claim_;
    IntervalPair intervals_;
    std::optional<ExactPair> exact_;  // made when the intervals do not decide
};

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

CertificateVerdict check_certificate(const PairQuery& query, const DistanceResult& result, Arithmetic arithmetic) {
    if (!is_well_formed(query, result)) return CertificateVerdict::malformed;
    if (!is_status_proved(result)) return CertificateVerdict::status_not_proved;
    Inequalities claim(query, result.certificate, arithmetic);
    if (claim.compare_separation(result.lower) < 0) return CertificateVerdict::lower_not_proved;
    if (!result.certificate.cores_overlap)
        return claim.compare_claimed_segment(result.upper) <= 0 ? CertificateVerdict::accepted
                                                                : CertificateVerdict::upper_not_proved;
    if (claim.compare_claimed_face(result.lower) < 0 || claim.compare_claimed_face(result.upper) > 0)
        return CertificateVerdict::face_not_proved;
    return claim.compare_depth(result.upper) <= 0 ? CertificateVerdict::accepted : CertificateVerdict::upper_not_proved;
}

}  // namespace tumble::reference
