// Casts and times of impact by Box2D.
#pragma once

#include <optional>

#include "reference/query/cast_query.hpp"

namespace tumble::reference {

struct B2Cast {
    bool hits = false;
    bool overlaps = false;  // at the start, as Box2D reports it
    double fraction = 1.0;
    double tolerance = 0.0;  // Box2D's own, around the target (m)
};

// The distance of bare cores at which Box2D stops (m).
double b2_target(CastKind kind);

// The answer of Box2D. Nothing for a ray at a shape that Box2D lacks, and for a cast or time of impact that is not of
// bare cores to b2_target(). One thread at a time.
std::optional<B2Cast> query_box2d(const CastQuery& query);

}  // namespace tumble::reference
