// Lists of queries to be timed. Each stores only what its query needs, because reading it is a notable part of a query.
#include <vector>

#include "reference/box2d_v3/library/v3_library.hpp"
#include "reference/box2d_v3/library/v3_types.hpp"

namespace tumble::box2d_v3 {

namespace {

struct Distances : Queries {
    struct Pair {
        b2DistanceInput input;
        b2Transform pose_a, pose_b;
        b2SimplexCache cache{};
    };
    std::vector<Pair> pairs{};
    bool is_warm = false;

    double run() override {
        double sum = 0.0;
        for (Pair& pair : pairs) {
            pair.input.transform = b2InvMulTransforms(pair.pose_a, pair.pose_b);
            if (!is_warm) pair.cache = {};
            sum += double{b2ShapeDistance(&pair.input, &pair.cache, nullptr, 0).distance};
        }
        return sum;
    }
};

struct Manifolds : Queries {
    struct Pair {
        b2Polygon a, b;
        b2Transform pose_a, pose_b;
    };
    std::vector<Pair> pairs{};

    double run() override {
        double sum = 0.0;
        for (const Pair& pair : pairs)
            sum += b2CollidePolygons(&pair.a, &pair.b, b2InvMulTransforms(pair.pose_a, pair.pose_b)).pointCount;
        return sum;
    }
};

struct Impacts : Queries {
    std::vector<b2TOIInput> inputs{};

    double run() override {
        double sum = 0.0;
        for (const b2TOIInput& input : inputs) sum += double{b2TimeOfImpact(&input).fraction};
        return sum;
    }
};

// The ray of the world in the frame of the shape.
b2RayCastInput local_ray(const b2Transform& pose, const b2RayCastInput& ray) {
    return {b2InvTransformPoint(pose, ray.origin), b2InvRotateVector(pose.q, ray.translation), ray.maxFraction};
}

template <class Shape, b2CastOutput (*cast)(const Shape*, const b2RayCastInput*)>
struct Rays : Queries {
    struct Query {
        Shape shape;
        b2Transform pose;
        b2RayCastInput ray;
    };
    std::vector<Query> queries{};

    double run() override {
        double sum = 0.0;
        for (const Query& query : queries) {
            const b2RayCastInput ray = local_ray(query.pose, query.ray);
            const b2CastOutput output = cast(&query.shape, &ray);
            if (output.hit) sum += double{output.fraction};
        }
        return sum;
    }
};

b2RayCastInput ray_of(const Ray& ray) { return {{ray.origin_x, ray.origin_y}, {ray.x, ray.y}, 1.0f}; }

}  // namespace

Queries* make_distances(std::span<const PosedPair> pairs, bool is_warm) {
    auto* const list = new Distances;
    list->is_warm = is_warm;
    for (const PosedPair& pair : pairs)
        list->pairs.push_back(
            {{proxy_of(pair.a), proxy_of(pair.b), {}, true}, transform_of(pair.pose_a), transform_of(pair.pose_b)});
    return list;
}

Queries* make_manifolds(std::span<const PosedPair> pairs) {
    auto* const list = new Manifolds;
    for (const PosedPair& pair : pairs)
        list->pairs.push_back(
            {polygon_of(pair.a), polygon_of(pair.b), transform_of(pair.pose_a), transform_of(pair.pose_b)});
    return list;
}

Queries* make_impacts(std::span<const MovingPair> pairs) {
    auto* const list = new Impacts;
    for (const MovingPair& pair : pairs)
        list->inputs.push_back({proxy_of(pair.a), proxy_of(pair.b), sweep_of(pair.of_a), sweep_of(pair.of_b), 1.0f});
    return list;
}

Queries* make_rays(std::span<const Ray> rays) {
    if (!rays.empty() && rays.front().shape.count == 1) {
        auto* const circles = new Rays<b2Circle, b2RayCastCircle>;
        for (const Ray& ray : rays)
            circles->queries.push_back({circle_of(ray.shape), transform_of(ray.pose), ray_of(ray)});
        return circles;
    }
    auto* const polygons = new Rays<b2Polygon, b2RayCastPolygon>;
    for (const Ray& ray : rays)
        polygons->queries.push_back({polygon_of(ray.shape), transform_of(ray.pose), ray_of(ray)});
    return polygons;
}

}  // namespace tumble::box2d_v3
