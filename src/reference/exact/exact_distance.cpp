#include "reference/exact/exact_distance.hpp"

#include <vector>

#include "reference/exact/exact_geometry.hpp"

namespace tumble::reference {

namespace {

struct ClosestSegment {
    SignedRoot distance;
    ExactPoint from, to;  // the segment of A - B that attains it
};

// The nearest of all segments of A - B that are the difference of a vertex of one core and an edge of the other. It is
// 0 for cores that touch, since a vertex of one lies on the other. Cores that overlap need the faces instead.
ClosestSegment closest_segment(const ExactPair& pair) {
    ClosestSegment closest;
    SegmentMeter meter(pair);
    ExactPoint from, to;
    bool first = true;
    const auto improve = [&] {
        const SignedRoot& candidate = meter.measure(from, to);
        if (!first && compare(candidate, closest.distance) >= 0) return;
        closest = {candidate, from, to};
        first = false;
    };
    const std::size_t n = pair.a.size(), m = pair.b.size();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < m; ++j) {
            const std::size_t next_i = i + 1 == n ? 0 : i + 1, next_j = j + 1 == m ? 0 : j + 1;
            set_difference(from, pair.a[i], pair.b[j]);
            set_difference(to, pair.a[i], pair.b[next_j]);
            improve();
            if (next_i == i) continue;
            set_difference(to, pair.a[next_i], pair.b[j]);
            improve();
        }
    }
    return closest;
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

}  // namespace

ExactDistance::ExactDistance(const PairQuery& query) : radius_a_(query.a.radius()), radius_b_(query.b.radius()) {
    const ExactPair pair = exact_pair(query);
    SignedRoot deepest;
    if (find_deepest_face(pair, deepest, true) && deepest.sign < 0) {
        core_ = std::move(deepest);
        return;
    }
    ClosestSegment closest = closest_segment(pair);
    unique_pair_ = is_unique(pair, closest);
    core_ = std::move(closest.distance);
}

int ExactDistance::compare(double x) const { return reference::compare(core_, exact_sum({x, radius_a_, radius_b_})); }

double ExactDistance::minus(double x) const { return rounded_difference(core_, exact_sum({x, radius_a_, radius_b_})); }

ExactDistance ExactDistance::with_radii(double radius_a, double radius_b) const {
    ExactDistance other = *this;
    other.radius_a_ = radius_a;
    other.radius_b_ = radius_b;
    return other;
}

}  // namespace tumble::reference
