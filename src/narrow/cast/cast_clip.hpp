// The path of the origin against A - B grown by a reach: where it starts, and where it meets the boundary first.
//
// B moves by t v, so that A - B moves by -t v: as if the origin went along v and A - B stayed. The boundary of the
// grown difference is its faces, moved outwards by the reach, and arcs around its vertices. A face is met if its moved
// ends lie on the two sides of the path (a test on signs that neighbours share); a whole circle is tried at each
// vertex, as what is no arc of it lies inside and is never met first. So nothing slips through a join. A vertex within
// the error bound of the path counts as met.
//
// Bracket: a face that closes at the rate s (m a whole motion) is met within E / s of the fraction found, a circle
// between the fractions at which the radii reach + 2E and reach - 2E are; without curvature (reach below 16 E) a vertex
// is met within E / s of the slower face beside it.
#pragma once

#include <cstdint>

#include "narrow/cores/core_pair.hpp"
#include "tumble/distance.hpp"

namespace tumble {

struct CastPath {
    DVec2 motion;   // v
    double length;  // |v|; 0 for no motion
    double reach;   // radii and target together
    double error;   // E
};

// A place on the boundary of A - B.
struct CastFeature {
    DVec2 normal;     // unit, outwards: from A to B
    VertexPair from;  // ends of the face; equal for a vertex
    VertexPair to;
    double along;  // where on the face: 0 at `from`, 1 at `to`
};

// Where the path meets the boundary. Never, if the fraction is infinite.
struct CastContact {
    double fraction;
    double lower;
    double upper;
    double rate;  // at which the boundary closes there
    CastFeature feature;
};

struct ClippedPath {
    CastContact first;            // for a start outside the grown difference
    CastFeature start;            // nearest to the origin, or closing fastest where the cores touch
    double start_rate = 0.0;      // at which it closes
    double start_distance = 0.0;  // signed distance of the cores at the start
    bool approaches = false;      // the motion goes below the start distance by more than rounding
    std::int32_t faces = 0;       // looked at
};

// O(n + m).
ClippedPath clip_path(const CorePair& pair, const CastPath& path);

}  // namespace tumble
