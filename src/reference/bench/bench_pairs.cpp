#include "reference/bench/bench_pairs.hpp"

#include "debug/check.hpp"
#include "reference/box2d/b2_types.hpp"
#include "reference/query/random.hpp"

namespace tumble::reference {

namespace {

constexpr std::size_t kLargeVertices = 1000;

Shape regular_polygon(std::size_t count, double radius) {
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count; ++i) {
        const SinCos at = sin_cos(2.0 * kPi * static_cast<double>(i) / static_cast<double>(count));
        points.push_back(to_float(radius * DVec2{at.cos, at.sin}));
    }
    return make_polygon(points);
}

// A shape of about a metre.
Shape shape_of(BenchKind kind, Random& random) {
    static const Shape large = regular_polygon(kLargeVertices, 0.5);  // shared by all pairs: it stays in the cache
    const auto size = [&random] { return static_cast<float>(random.uniform(0.5, 1.5)); };
    switch (kind) {
        case BenchKind::circle: return make_circle(0.5f * size());
        case BenchKind::capsule: return make_capsule({-0.5f * size(), 0}, {0.5f * size(), 0}, 0.25f * size());
        case BenchKind::box: return make_box({size(), size()});
        case BenchKind::octagon: return regular_polygon(8, 0.5 * size());
        case BenchKind::large: return large;
    }
    return {};
}

BenchPair random_pair(BenchKind kind_a, BenchKind kind_b, double gap, Random& random) {
    const auto pose = [&random](DVec2 around, double by) {
        const double x = random.uniform(-by, by), y = random.uniform(-by, by);
        return Pose{around + DVec2{x, y}, make_rotation(random.uniform(-kPi, kPi))};
    };
    BenchPair pair{shape_of(kind_a, random), shape_of(kind_b, random), pose({}, 10), {}, {}};
    pair.pose_b = pose(pair.pose_a.position, 1.0);
    for (int round = 0; round < 3; ++round) {
        const DistanceResult now = distance(pair.a, pair.pose_a, pair.b, pair.pose_b);
        pair.pose_b.position += (gap - now.distance) * now.normal;
    }
    return pair;
}

}  // namespace

std::vector<BenchPair> random_pairs(BenchKind kind_a, BenchKind kind_b, double gap, int count, std::uint64_t seed) {
    std::vector<BenchPair> pairs;
    for (int i = 0; i < count; ++i) {
        Random random(seed, static_cast<std::uint64_t>(i));
        pairs.push_back(random_pair(kind_a, kind_b, gap, random));
    }
    return pairs;
}

std::vector<b2Vec2> vertices_of(const Shape& shape) {
    std::vector<b2Vec2> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i) vertices.push_back(to_b2(DVec2(shape.vertex(i))));
    return vertices;
}

std::size_t vertex_total(const std::vector<BenchPair>& pairs) {
    std::size_t total = 0;
    for (const BenchPair& pair : pairs)
        total += static_cast<std::size_t>(pair.a.vertex_count() + pair.b.vertex_count());
    return total;
}

b2DistanceProxy Proxies::make(const Shape& shape) {
    TUMBLE_CHECK(vertices_.size() + static_cast<std::size_t>(shape.vertex_count()) <= vertices_.capacity());
    const b2Vec2* first = vertices_.data() + vertices_.size();
    for (const b2Vec2& vertex : vertices_of(shape)) vertices_.push_back(vertex);
    b2DistanceProxy proxy;
    proxy.Set(first, shape.vertex_count(), shape.radius());
    return proxy;
}

}  // namespace tumble::reference
