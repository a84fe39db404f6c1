// Times of impact and rays.
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_time_of_impact.h>

#include <memory>

#include "reference/bench/case_makers.hpp"
#include "reference/bench/v3_runs.hpp"
#include "reference/box2d/b2_types.hpp"
#include "reference/query/random.hpp"
#include "tumble/cast.hpp"

namespace tumble::reference {

namespace {

constexpr float kTarget = b2_linearSlop;  // b2TimeOfImpact stops at this distance of cores without radius

struct ImpactPairs {
    std::vector<BenchImpact> ours;
    Proxies proxies;
    std::vector<b2TOIInput> theirs;

    ImpactPairs(const std::vector<BenchPair>& pairs, std::uint64_t seed) : proxies(vertex_total(pairs)) {
        for (std::size_t i = 0; i < pairs.size(); ++i) add(pairs[i], Random(~seed, i));
    }

private:
    // B moves by twice the gap along the normal, and both shapes turn.
    void add(const BenchPair& pair, Random random) {
        const DistanceResult start = distance(pair.a, pair.pose_a, pair.b, pair.pose_b);
        const DVec2 displacement = (-2.0 * start.distance) * start.normal;
        const auto sweep = [&](const Pose& pose, DVec2 translation) {
            return Sweep{
                {}, pose.position, pose.position + translation, angle(pose.rotation), random.uniform(-1.0, 1.0)};
        };
        const Sweep sweep_a = sweep(pair.pose_a, {}), sweep_b = sweep(pair.pose_b, displacement);
        ours.push_back({pair.a, pair.b, sweep_a, sweep_b});
        theirs.push_back({proxies.make(pair.a), proxies.make(pair.b), to_b2(sweep_a), to_b2(sweep_b), 1.0f});
    }
};

}  // namespace

QueryCase impact_case(const std::string& name, BenchKind kind) {
    return {name, [=](int count, std::uint64_t seed) -> QueryRuns {
                const auto pairs = std::make_shared<ImpactPairs>(random_pairs(kind, kind, 0.5, count, seed), seed);
                return {[=] {
                            double sum = 0.0;
                            for (const BenchImpact& query : pairs->ours)
                                sum += time_of_impact(query.a, query.sweep_a, query.b, query.sweep_b, kTarget).fraction;
                            return sum;
                        },
                        [=] {
                            double sum = 0.0;
                            for (const b2TOIInput& input : pairs->theirs) {
                                b2TOIOutput output;
                                b2TimeOfImpact(&output, &input);
                                sum += output.t;
                            }
                            return sum;
                        },
                        v3_impacts(pairs->ours)};
            }};
}

namespace {

// Rays from the position of the pair's second shape to the centre of the first, so that each hits. Each engine's list
// stores only what its query needs, because reading it is a notable part of a query this short.
template <class B2Shape>
struct RayQueries {
    struct TheirQuery {
        B2Shape shape;
        b2Transform pose;
        b2RayCastInput input;
    };
    std::vector<BenchRay> ours;
    std::vector<TheirQuery> theirs;

    explicit RayQueries(const std::vector<BenchPair>& pairs) {
        for (const BenchPair& pair : pairs) {
            const DVec2 origin = pair.pose_b.position, end = pair.pose_a.position;
            ours.push_back({pair.a, pair.pose_a, origin, end - origin});
            TheirQuery& query = theirs.emplace_back();
            set(query.shape, pair.a);
            query.pose = to_b2(pair.pose_a);
            query.input = {to_b2(origin), to_b2(end), 1.0f};
        }
    }

private:
    static void set(b2CircleShape& circle, const Shape& shape) { circle.m_radius = shape.radius(); }
    static void set(b2PolygonShape& polygon, const Shape& shape) {
        polygon.Set(vertices_of(shape).data(), shape.vertex_count());
    }
};

template <class B2Shape>
QueryCase ray_case(const std::string& name, BenchKind kind) {
    return {name, [=](int count, std::uint64_t seed) -> QueryRuns {
                const auto rays = std::make_shared<RayQueries<B2Shape>>(random_pairs(kind, kind, 1.0, count, seed));
                return {[=] {
                            double sum = 0.0;
                            for (const auto& query : rays->ours)
                                sum += cast_ray(query.shape, query.pose, query.origin, query.translation).fraction;
                            return sum;
                        },
                        [=] {
                            double sum = 0.0;
                            for (const auto& query : rays->theirs) {
                                b2RayCastOutput output;
                                if (query.shape.RayCast(&output, query.input, query.pose, 0)) sum += output.fraction;
                            }
                            return sum;
                        },
                        v3_rays(rays->ours)};
            }};
}

}  // namespace

QueryCase circle_ray_case(const std::string& name, BenchKind kind) { return ray_case<b2CircleShape>(name, kind); }
QueryCase polygon_ray_case(const std::string& name, BenchKind kind) { return ray_case<b2PolygonShape>(name, kind); }

}  // namespace tumble::reference
