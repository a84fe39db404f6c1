// The closest features of two cores that have moved a little: mostly the same ones. Then their distance is measured without
// a search, and the neighbours of its vertices prove that it is the shapes'.
#pragma once

#include "narrow/core_distance.hpp"

namespace tumble {

struct LedDistance {
    CoreDistance core;       // distance, normal and pairs only
    bool exists = false;     // false if there was no simplex of one or two vertices, or it holds the origin
    bool is_proved = false;  // no neighbour is nearer: the distance is that of the cores; else an upper bound
};

LedDistance distance_of_simplex(const CorePair& pair, const SimplexCache& cache);

}  // namespace tumble
