// One query about moving shapes as plain data, and what both engines answer to it.
#pragma once

#include <cstdint>
#include <optional>

#include "reference/pair_query.hpp"
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
