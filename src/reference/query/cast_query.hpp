// A query about moving shapes as plain data, and tumble's answer to it.
#pragma once

#include <cstdint>

#include "reference/query/pair_query.hpp"
#include "tumble/cast.hpp"

namespace tumble::reference {

enum class CastKind : std::uint8_t { ray, shape, impact };

struct CastQuery {
    CastKind kind = CastKind::ray;
    Shape a, b;              // b of a ray is a point
    Pose pose_a, pose_b;     // of a ray or a shape cast
    DVec2 translation;       // of B relative to A, in a ray or a shape cast
    Sweep sweep_a, sweep_b;  // of a time of impact
    double target = 0.0;     // signed distance
};

CastResult query_tumble(const CastQuery& query);

// The shapes at their poses at the start.
PairQuery start_of(const CastQuery& query);

}  // namespace tumble::reference
