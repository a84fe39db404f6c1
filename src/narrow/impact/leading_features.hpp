// The closest features of two moving cores. They are mostly the same from one step to the next: their distance is then
// measured without a search, and proved to be that of the cores.
#pragma once

#include "narrow/distance/core_distance.hpp"
#include "narrow/distance/small_features.hpp"

namespace tumble {

// A face of one core with a vertex of the other, two vertices, or neither: parallel edges of both.
struct LeadingFeature {
    enum class Kind : std::uint8_t { none, face, vertices };

    double distance = 0.0;  // signed, of the cores
    DVec2 normal;           // unit, from A to B
    VertexPair pairs[2];    // the ends of the feature; equal for two vertices
    Kind kind = Kind::none;
    unsigned owner = 0;  // of a face: 0 is A, 1 is B
    DVec2 local_edge;    // of a face: the unit vector along its edge in the owner's coordinates
    double edge_length = 0.0;
    double outwards = 1.0;  // 1: the outward normal is on the right of `local_edge`; -1: on its left
};

// Takes the feature that a core distance ended with.
void take(LeadingFeature& feature, const CorePair& pair, const CoreDistance& core);

// Measures the feature where the cores are now. True if it is proved that no other is nearer: a face with the other
// core's support vertex above its inside, or two vertices of which each is the support towards the other. For two
// vertices the distance is an upper bound anyway.
bool follow(const CorePair& pair, LeadingFeature& feature);

}  // namespace tumble
