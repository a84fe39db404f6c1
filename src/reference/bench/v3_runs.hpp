// The runs of timed queries by Box2D v3. Each is empty if the build lacks it, or a core has more than eight vertices.
#pragma once

#include <vector>

#include "reference/bench/bench_pairs.hpp"
#include "reference/bench/query_cases.hpp"

namespace tumble::reference {

QueryRun v3_distances(const std::vector<BenchPair>& pairs, bool is_warm);

// Box2D v3 has no cache of manifolds.
QueryRun v3_manifolds(const std::vector<BenchPair>& pairs);

// Box2D v3 interpolates rotations in another way, so that a shape that turns far moves a little differently.
QueryRun v3_impacts(const std::vector<BenchImpact>& impacts);

QueryRun v3_rays(const std::vector<BenchRay>& rays);

}  // namespace tumble::reference
