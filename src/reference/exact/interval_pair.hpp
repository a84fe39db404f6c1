// Two cores at their poses in long double, and intervals that contain their exact separations and distances.
// INTERVALS.md derives their width: e = 32 u S on either side, a thousandth of the error bound that tumble states.
#pragma once

#include <vector>

#include "reference/exact/brute_distance.hpp"
#include "reference/exact/interval.hpp"
#include "reference/query/pair_query.hpp"
#include "tumble/distance.hpp"

namespace tumble::reference {

// exact_only makes every interval the whole line, so that nothing is decided without exact arithmetic.
enum class Arithmetic { intervals_first, exact_only };

// The face whose normal is that of an edge of A or of B; the edge is named by its first vertex.
struct EstimatedFace {
    bool is_of_a = true;
    std::size_t edge = 0;
    Interval separation;
};

// The segment of A - B between two of its vertices, which are the difference of a vertex and an edge.
struct EstimatedSegment {
    VertexPair from, to;
    Interval distance;
};

class IntervalPair {
public:
    // The query must be finite and outlive the pair. The intervals are the whole line if an outline is not convex.
    explicit IntervalPair(const PairQuery& query, Arithmetic arithmetic = Arithmetic::intervals_first);

    // Of -h / |direction|, as in separation() of exact_geometry.hpp. The direction must not be zero.
    Interval separation(DVec2 direction) const;

    // Of the distance of the origin from a segment between two vertices of A - B. The indices must be in range.
    Interval segment_distance(VertexPair from, VertexPair to) const;

    // Of the separation along that normal of the segment that points in the direction; if both ends are the same
    // vertex, of the negative distance of that vertex from the origin.
    Interval face_separation(VertexPair from, VertexPair to, DVec2 direction) const;

    // The faces of A - B up to the first whose separation is certainly positive, which proves that the cores are apart.
    // None for two points. For more than kSearchAll vertices the intervals have no lower end.
    std::vector<EstimatedFace> faces() const;

    // The segments of A - B that are the difference of a vertex of one core and an edge of the other, without those
    // that are certainly farther from the origin than an earlier one.
    std::vector<EstimatedSegment> segments() const;

private:
    brute::Point vertex(VertexPair pair) const { return a_[pair.a] - b_[pair.b]; }
    void add_faces(std::vector<EstimatedFace>& faces, bool is_of_a) const;

    const PairQuery& query_;
    std::vector<brute::Point> a_, b_;  // relative to A's position
    brute::Real error_ = 0;            // e (m)
};

}  // namespace tumble::reference
