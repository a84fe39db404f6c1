#include "reference/exact/exact_distance.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "debug/check.hpp"
#include "reference/exact/candidates.hpp"
#include "reference/exact/exact_geometry.hpp"

namespace tumble::reference {

namespace {

struct ClosestSegment {
    SignedRoot distance;
    ExactPoint from, to;  // the segment of A - B that attains it
};

// The nearest to the origin. It is 0 for cores that touch, since a vertex of one lies on the other. Cores that overlap
// need the faces instead.
ClosestSegment closest_segment(const ExactPair& pair, const std::vector<EstimatedSegment>& segments) {
    TUMBLE_CHECK(!segments.empty());
    ClosestSegment closest;
    SegmentMeter meter(pair);
    ExactPoint from, to;
    for (const EstimatedSegment& segment : segments) {
        set_difference(from, pair.a[segment.from.a], pair.b[segment.from.b]);
        set_difference(to, pair.a[segment.to.a], pair.b[segment.to.b]);
        const SignedRoot& candidate = meter.measure(from, to);
        if (&segment == &segments[0] || compare(candidate, closest.distance) < 0) closest = {candidate, from, to};
    }
    return closest;
}

// False if there are none.
bool find_deepest(const ExactPair& pair, const std::vector<EstimatedFace>& faces, SignedRoot& deepest) {
    bool found = false;
    for (const EstimatedFace& face : faces) {
        SignedRoot candidate = separation(pair, face_normal(pair, face.is_of_a, face.edge));
        if (!found || compare(candidate, deepest) > 0) deepest = std::move(candidate);
        found = true;
    }
    return found;
}

// True if more than one point of the outline is extreme in the direction.
bool is_face(const std::vector<ExactPoint>& outline, const ExactPoint& direction) {
    const auto along = [&](const ExactPoint& p) { return mpz_class(direction.x * p.x + direction.y * p.y); };
    const ExactPoint* extreme = &outline[0];
    bool several = false;
    for (const ExactPoint& point : outline) {
        const int order = cmp(along(point), along(*extreme));
        if (order < 0 || is_zero(point - *extreme)) continue;
        several = order == 0;
        if (order > 0) extreme = &point;
    }
    return several;
}

// A positive multiple of the point of the segment nearest to the origin.
ExactPoint closest_direction(const ExactPoint& from, const ExactPoint& to) {
    const ExactPoint edge = to - from;
    const mpz_class along = -(from.x * edge.x + from.y * edge.y);
    if (along <= 0) return from;
    if (along >= edge.x * edge.x + edge.y * edge.y) return to;
    const int side = sgn(mpz_class(from.x * to.y - from.y * to.x)) < 0 ? -1 : 1;
    return {side * edge.y, -side * edge.x};
}

bool is_unique(const ExactPair& pair, const ClosestSegment& closest) {
    if (closest.distance.sign == 0) return false;
    const ExactPoint v = closest_direction(closest.from, closest.to);
    return !(is_face(pair.b, v) && is_face(pair.a, {-v.x, -v.y}));
}

struct ExactCores {
    SignedRoot distance;  // signed
    bool has_unique_pair = false;
};

ExactCores exact_cores(const PairQuery& query, const Candidates& candidates) {
    const ExactPair pair = exact_pair(query);
    ExactCores cores;
    if (find_deepest(pair, candidates.faces, cores.distance) && cores.distance.sign < 0) return cores;
    ClosestSegment closest = closest_segment(pair, candidates.segments);
    cores.has_unique_pair = is_unique(pair, closest);
    cores.distance = std::move(closest.distance);
    return cores;
}

}  // namespace

class ExactDistance::Cores {
public:
    Cores(const PairQuery& query, Arithmetic arithmetic)
        : query_(query), candidates_(find_candidates(IntervalPair(query_, arithmetic))) {}

    Interval interval() const { return candidates_.distance; }

    const ExactCores& exact() {
        if (!exact_) exact_ = exact_cores(query_, candidates_);
        return *exact_;
    }

private:
    PairQuery query_;
    Candidates candidates_;
    std::optional<ExactCores> exact_;
};

ExactDistance::ExactDistance(const PairQuery& query, Arithmetic arithmetic)
    : cores_(std::make_shared<Cores>(query, arithmetic)), radius_a_(query.a.radius()), radius_b_(query.b.radius()) {}

int ExactDistance::compare(double x, double offset) const {
    const std::initializer_list<double> summands{x, offset, radius_a_, radius_b_};
    if (const auto sign = reference::compare(cores_->interval(), interval_sum(summands))) return *sign;
    return reference::compare(cores_->exact().distance, exact_sum(summands));
}

double ExactDistance::minus(double x) const {
    return rounded_difference(cores_->exact().distance, exact_sum({x, radius_a_, radius_b_}));
}

ExactDistance ExactDistance::with_radii(double radius_a, double radius_b) const {
    ExactDistance other = *this;
    other.radius_a_ = radius_a;
    other.radius_b_ = radius_b;
    return other;
}

bool ExactDistance::has_unique_pair() const { return cores_->exact().has_unique_pair; }

}  // namespace tumble::reference
