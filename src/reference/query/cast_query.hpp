// One query about moving shapes as plain data, and tumble's answer to it.
#pragma once

#include <cstdint>

#include "reference/query/pair_query.hpp"
#include "tumble/cast.hpp"

namespace tumble::reference {

enum class CastKind : std::uint8_t { ray, shape, impact };

struct CastQuery {
    CastKind kind = CastKind::ray;
    Shape a, b;              // b of a ray is a point
    Pose pose_a, pose_b;     // of a ray or a shape cast...
    DVec2 translation;       // ...in which B moves relative to A
    Sweep sweep_a, sweep_b;  // of a time of impact
    double target = 0.0;     // signed distance
};

CastResult ask_tumble(const CastQuery& query);

// The shapes where they start.
PairQuery start_of(const CastQuery& query);

}  // namespace tumble::reference
