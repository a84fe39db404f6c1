// The random pairs of shapes that queries are timed on, for both engines.
#pragma once

#include <box2d/b2_distance.h>

#include <cstdint>
#include <vector>

#include "tumble/cast.hpp"
#include "tumble/distance.hpp"
#include "tumble/shape.hpp"

namespace tumble::reference {

enum class BenchKind { circle, capsule, box, octagon, large };

struct BenchPair {
    Shape a, b;
    Pose pose_a, pose_b;
    SimplexCache cache;
};

struct BenchImpact {
    Shape a, b;
    Sweep sweep_a, sweep_b;
};

struct BenchRay {
    Shape shape;
    Pose pose;
    DVec2 origin, translation;
};

// `count` pairs of shapes of about a metre. A is within 10 m of the origin on each axis, and B is `gap` (m, negative
// for overlap) from A in a random direction.
std::vector<BenchPair> random_pairs(BenchKind kind_a, BenchKind kind_b, double gap, int count, std::uint64_t seed);

std::vector<b2Vec2> vertices_of(const Shape& shape);
std::size_t vertex_total(const std::vector<BenchPair>& pairs);

// Makes Box2D proxies, which keep pointers to vertices. The vertices are in one array of the size given to the
// constructor.
class Proxies {
public:
    explicit Proxies(std::size_t vertices) { vertices_.reserve(vertices); }

    b2DistanceProxy make(const Shape& shape);

private:
    std::vector<b2Vec2> vertices_;
};

}  // namespace tumble::reference
