// Queries: the broad phase finds candidate shapes, the narrow phase computes the answers, and the best answer so far
// bounds the search.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/state/simulation.hpp"
#include "tumble/query.hpp"

namespace tumble {

// These answer the queries of World (tumble/world.hpp), which has checked the arguments.
std::optional<CastHit> find_ray_hit(const Simulation& simulation, DVec2 origin, DVec2 translation,
                                    const QueryFilter& filter);
std::vector<CastHit> find_ray_hits(const Simulation& simulation, DVec2 origin, DVec2 translation,
                                   const QueryFilter& filter);
std::optional<CastHit> find_shape_hit(const Simulation& simulation, const Shape& shape, const Pose& pose,
                                      DVec2 translation, const QueryFilter& filter);
std::vector<ShapeId> find_overlaps(const Simulation& simulation, const Shape& shape, const Pose& pose,
                                   const QueryFilter& filter);
std::vector<ShapeId> find_overlaps(const Simulation& simulation, DVec2 lower, DVec2 upper, const QueryFilter& filter);
std::optional<ClosestHit> find_closest(const Simulation& simulation, DVec2 point, double max_distance,
                                       const QueryFilter& filter);
BodyDistance find_distance(const Simulation& simulation, BodyId a, BodyId b);

}  // namespace tumble
