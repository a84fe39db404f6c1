// Makes the cases of one kind of query, warm (each pair's cache is kept from run to run) or cold.
#pragma once

#include <string>

#include "reference/bench/bench_pairs.hpp"
#include "reference/bench/query_cases.hpp"

namespace tumble::reference {

QueryCase distance_case(const std::string& name, BenchKind kind_a, BenchKind kind_b, double gap, bool is_warm);

// All distances in one call of distance_batch(), beside single ones of Box2D.
QueryCase batch_case(const std::string& name, BenchKind kind, double gap);

// b2CollidePolygons has no cache: its time is the same, warm and cold.
QueryCase manifold_case(const std::string& name, BenchKind kind, double gap, bool is_warm);

// Times of impact of shapes that approach each other by twice their gap and turn.
QueryCase impact_case(const std::string& name, BenchKind kind);

// Rays that hit, at circles and at polygons.
QueryCase circle_ray_case(const std::string& name, BenchKind kind);
QueryCase polygon_ray_case(const std::string& name, BenchKind kind);

}  // namespace tumble::reference
