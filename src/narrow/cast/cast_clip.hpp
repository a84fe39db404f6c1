// The path of the origin clipped by A - B grown by a reach: its start, and its first contact with the boundary.
//
// B moves by t v, so A - B moves by -t v, which is the same as the origin moving along v while A - B rests
// [Eri04, 5.5]. The boundary of the grown difference is its faces, moved outwards by the reach, and arcs around its
// vertices. The path crosses a face if the face's moved ends lie on different sides of it, a test on signs that
// neighbouring faces share. At each vertex a whole circle is tried: the part of it that is not on the boundary lies
// inside and is never reached first. So no path passes between a face and an arc. A vertex within the error bound of
// the path counts as reached.
//
// Bracket: a face that closes at the rate s (m a whole motion) is reached within E / s of the fraction found, a circle
// between the fractions of the circles of radius reach + 2E and reach - 2E. Without curvature (reach below 16 E) a
// vertex is reached within E / s of the slower face beside it.
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

// A point on the boundary of A - B.
struct CastFeature {
    DVec2 normal;     // unit, outwards: from A to B
    VertexPair from;  // ends of the face; equal for a vertex
    VertexPair to;
    double along;  // position on the face: 0 at `from`, 1 at `to`
};

// A contact of the path with the boundary; none if the fraction is infinite.
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
    std::int32_t faces = 0;       // of the difference
};

// O(n + m).
ClippedPath clip_path(const CorePair& pair, const CastPath& path);

}  // namespace tumble
