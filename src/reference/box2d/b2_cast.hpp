// Casts and times of impact by Box2D.
#pragma once

#include <optional>

#include "reference/query/cast_query.hpp"

namespace tumble::reference {

struct B2Cast {
    bool hits = false;
    bool overlaps = false;  // at the start, in its own words
    double fraction = 1.0;
    double tolerance = 0.0;  // of its own, around the target (m)
};

// The distance of bare cores at which Box2D stops.
double b2_target(CastKind kind);

// Nothing for rays against what it has no shape for. Casts and times of impact must be of bare cores and to its own
// target, into which it takes the radii. One thread at a time.
std::optional<B2Cast> ask_box2d(const CastQuery& query);

}  // namespace tumble::reference
