// The faces of the Minkowski difference A - B: an edge of one core and the support vertex of the other.
//
// In the plane the depth of overlapping cores needs no expanding polytope: it is minus the largest separation over all
// faces, exactly. [Cam97] bounds this penetration distance in three dimensions.
#pragma once

#include "narrow/cores/support.hpp"

namespace tumble {

struct Face {
    DVec2 direction;          // normal to the edge, from A to B, not of unit length
    double separation = 0.0;  // of the cores along `direction`; negative if they overlap
    VertexPair pairs[2];      // its ends; both have the same index of the core that does not own the edge
};

// The face of the edge that starts at a vertex of A or of B. `exists` is false for an edge without length.
struct FoundFace {
    Face face;
    bool exists = false;
};
FoundFace face_of_a(const CorePair& pair, int edge);
FoundFace face_of_b(const CorePair& pair, int edge);

// The face of largest separation; ties go to A, then to the lowest edge. None if both cores are points.
FoundFace deepest_face(const CorePair& pair);

// If edges of both cores are parallel up to rounding, an edge and a support vertex are only a part of the face, and the
// origin may project onto another part. Moves the pairs to that part.
void move_below_origin(const CorePair& pair, Face& face);

}  // namespace tumble
