// Contact manifolds of polygons.
#include <box2d/b2_collision.h>
#include <box2d/b2_polygon_shape.h>

#include <memory>

#include "reference/bench/case_makers.hpp"
#include "reference/bench/v3_runs.hpp"
#include "reference/box2d/b2_types.hpp"
#include "tumble/manifold.hpp"

namespace tumble::reference {

constexpr double kSpeculative = 0.02;  // m

namespace {

struct ManifoldPairs {
    std::vector<BenchPair> ours;
    struct Query {
        b2PolygonShape a, b;
        b2Transform pose_a, pose_b;
    };
    std::vector<Query> theirs;

    explicit ManifoldPairs(std::vector<BenchPair> pairs) : ours(std::move(pairs)) {
        for (const BenchPair& pair : ours) {
            Query& query = theirs.emplace_back();
            query.a.Set(vertices_of(pair.a).data(), pair.a.vertex_count());
            query.b.Set(vertices_of(pair.b).data(), pair.b.vertex_count());
            query.pose_a = to_b2(pair.pose_a);
            query.pose_b = to_b2(pair.pose_b);
        }
    }
};

}  // namespace

QueryCase manifold_case(const std::string& name, BenchKind kind, double gap, bool is_warm) {
    return {name + (is_warm ? " warm" : " cold"), [=](int count, std::uint64_t seed) -> QueryRuns {
                const auto pairs = std::make_shared<ManifoldPairs>(random_pairs(kind, kind, gap, count, seed));
                return {
                    [=] {
                        double sum = 0.0;
                        for (BenchPair& pair : pairs->ours) {
                            if (!is_warm) pair.cache = {};
                            sum +=
                                collide(pair.a, pair.pose_a, pair.b, pair.pose_b, kSpeculative, pair.cache).point_count;
                        }
                        return sum;
                    },
                    [=] {
                        double sum = 0.0;
                        for (const ManifoldPairs::Query& query : pairs->theirs) {
                            b2Manifold manifold;
                            b2CollidePolygons(&manifold, &query.a, query.pose_a, &query.b, query.pose_b);
                            sum += manifold.pointCount;
                        }
                        return sum;
                    },
                    v3_manifolds(pairs->ours)};
            }};
}

}  // namespace tumble::reference
