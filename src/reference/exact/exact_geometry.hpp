// Two cores at their poses in exact integers, and the geometry that the oracle and the checker share.
//
// Coordinates are in world axes relative to A's position, in units of 2^exponent. c, s and positions are used as they
// are: a rotation need not have unit length. The vertices form a convex outline in counter-clockwise order; repeated
// and collinear ones are allowed.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/exact/exact_number.hpp"
#include "reference/query/pair_query.hpp"
#include "tumble/distance.hpp"

namespace tumble::reference {

struct ExactPoint {
    mpz_class x = 0;
    mpz_class y = 0;
};

ExactPoint operator-(const ExactPoint& p, const ExactPoint& q);
bool is_zero(const ExactPoint& p);

struct ExactPair {
    std::vector<ExactPoint> a;  // [a.vertex_count()]
    std::vector<ExactPoint> b;  // [b.vertex_count()]
    int exponent = 0;
};

// The query must be finite (is_finite(PairQuery)).
ExactPair exact_pair(const PairQuery& query);

// The vertex of the Minkowski difference with these indices, which must be in range.
ExactPoint minkowski_vertex(const ExactPair& pair, VertexPair indices);

// h(direction): the maximum of direction . (a - b) over all vertices. O(n + m).
mpz_class support_value(const ExactPair& pair, const ExactPoint& direction);

// -h / |direction|, a lower bound on the signed core distance. The direction must not be zero, and is in the pair's
// units.
SignedRoot separation(const ExactPair& pair, const ExactPoint& direction);

// Computes the distance of the origin from segments between two points of the Minkowski difference, which may be equal.
// One meter measures many segments without an allocation for each.
class SegmentMeter {
public:
    explicit SegmentMeter(const ExactPair& pair) { root_.exponent = pair.exponent; }

    // Valid until the next call.
    const SignedRoot& measure(const ExactPoint& from, const ExactPoint& to);

private:
    SignedRoot root_;
    ExactPoint edge_;
    mpz_class along_;
};

SignedRoot segment_distance(const ExactPair& pair, const ExactPoint& from, const ExactPoint& to);

void set_difference(ExactPoint& target, const ExactPoint& p, const ExactPoint& q);

// A multiple of the direction, in its own units.
ExactPoint exact_direction(DVec2 direction);

// The separation along that normal of the segment between two vertices of A - B that points in the direction. If both
// are the same point, its negative distance from the origin.
SignedRoot claimed_face_separation(const ExactPair& pair, const ExactPoint& w1, const ExactPoint& w2,
                                   const ExactPoint& direction);

// Normal to an edge of A, outward, or to one of B, inward, since B enters negated. The edge is named by its first
// vertex; its length must not be 0.
ExactPoint face_normal(const ExactPair& pair, bool is_of_a, std::size_t edge);

// The largest separation over the faces of the Minkowski difference, which is the signed core distance if it is not
// positive. False if both cores are points, which have no face. O((n + m)^2) for outlines of up to 64 vertices. For
// larger ones the support vertex is followed around the outline, O(n + m), which requires convexity.
bool find_deepest_face(const ExactPair& pair, SignedRoot& deepest);

}  // namespace tumble::reference
