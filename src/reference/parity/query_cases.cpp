#include "reference/parity/query_cases.hpp"

#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_time_of_impact.h>

#include <array>
#include <memory>

#include "reference/box2d/b2_types.hpp"
#include "reference/query/random.hpp"
#include "tumble/cast.hpp"
#include "tumble/distance.hpp"
#include "tumble/manifold.hpp"

namespace tumble::reference {

namespace {

enum class Kind { circle, capsule, box, octagon, large };

constexpr float kTarget = b2_linearSlop;  // b2TimeOfImpact stops this far before contact, for cores without radius
constexpr double kSpeculative = 0.02;     // m, of manifolds
constexpr std::size_t kLargeVertices = 1000;

Shape regular_polygon(std::size_t count, double radius) {
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count; ++i) {
        const SinCos at = sin_cos(2.0 * kPi * static_cast<double>(i) / static_cast<double>(count));
        points.push_back(to_float(radius * DVec2{at.cos, at.sin}));
    }
    return make_polygon(points);
}

// About a metre.
Shape shape_of(Kind kind, Random& random) {
    static const Shape large = regular_polygon(kLargeVertices, 0.5);  // one, which stays in the processor's cache
    const auto size = [&random] { return static_cast<float>(random.uniform(0.5, 1.5)); };
    switch (kind) {
        case Kind::circle: return make_circle(0.5f * size());
        case Kind::capsule: return make_capsule({-0.5f * size(), 0}, {0.5f * size(), 0}, 0.25f * size());
        case Kind::box: return make_box({size(), size()});
        case Kind::octagon: return regular_polygon(8, 0.5 * size());
        case Kind::large: return large;
    }
    return {};
}

struct Pair {
    Shape a, b;
    Pose pose_a, pose_b;
    SimplexCache cache;
};

// Anywhere within 10 m, the surfaces `gap` apart (m, negative: deep) in a random direction.
Pair random_pair(Kind kind_a, Kind kind_b, double gap, Random& random) {
    const auto pose = [&random](DVec2 around, double by) {
        const double x = random.uniform(-by, by), y = random.uniform(-by, by);
        return Pose{around + DVec2{x, y}, make_rotation(random.uniform(-kPi, kPi))};
    };
    Pair pair{shape_of(kind_a, random), shape_of(kind_b, random), pose({}, 10), {}, {}};
    pair.pose_b = pose(pair.pose_a.position, 1.0);
    for (int round = 0; round < 3; ++round) {
        const DistanceResult now = distance(pair.a, pair.pose_a, pair.b, pair.pose_b);
        pair.pose_b.position += (gap - now.distance) * now.normal;
    }
    return pair;
}

std::vector<b2Vec2> vertices_of(const Shape& shape) {
    std::vector<b2Vec2> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i) vertices.push_back(to_b2(DVec2(shape.vertex(i))));
    return vertices;
}

// All vertices in one array: a proxy keeps a pointer to its own.
class Proxies {
public:
    explicit Proxies(std::size_t vertices) { vertices_.reserve(vertices); }

    b2DistanceProxy make(const Shape& shape) {
        const b2Vec2* first = vertices_.data() + vertices_.size();
        for (const b2Vec2& vertex : vertices_of(shape)) vertices_.push_back(vertex);
        b2DistanceProxy proxy;
        proxy.Set(first, shape.vertex_count(), shape.radius());
        return proxy;
    }

private:
    std::vector<b2Vec2> vertices_;
};

std::vector<Pair> random_pairs(Kind kind_a, Kind kind_b, double gap, int count, std::uint64_t seed) {
    std::vector<Pair> pairs;
    for (int i = 0; i < count; ++i) {
        Random random(seed, static_cast<std::uint64_t>(i));
        pairs.push_back(random_pair(kind_a, kind_b, gap, random));
    }
    return pairs;
}

std::size_t vertex_total(const std::vector<Pair>& pairs) {
    std::size_t total = 0;
    for (const Pair& pair : pairs) total += static_cast<std::size_t>(pair.a.vertex_count() + pair.b.vertex_count());
    return total;
}

struct DistancePairs {
    std::vector<Pair> ours;
    Proxies proxies;
    struct Query {
        b2DistanceInput input;
        b2SimplexCache cache;
    };
    std::vector<Query> theirs;

    explicit DistancePairs(std::vector<Pair> pairs) : ours(std::move(pairs)), proxies(vertex_total(ours)) {
        for (const Pair& pair : ours) {
            Query& query = theirs.emplace_back();
            query.input = {proxies.make(pair.a), proxies.make(pair.b), to_b2(pair.pose_a), to_b2(pair.pose_b), true};
            query.cache.count = 0;
        }
    }
};

double run_tumble(std::vector<Pair>& pairs, bool is_warm) {
    double sum = 0.0;
    for (Pair& pair : pairs)
        sum += distance(pair.a, pair.pose_a, pair.b, pair.pose_b, is_warm ? &pair.cache : nullptr).distance;
    return sum;
}

double run_box2d(std::vector<DistancePairs::Query>& queries, bool is_warm) {
    double sum = 0.0;
    for (DistancePairs::Query& query : queries) {
        if (!is_warm) query.cache.count = 0;
        b2DistanceOutput output;
        b2Distance(&output, &query.cache, &query.input);
        sum += output.distance;
    }
    return sum;
}

QueryCase distance_case(const std::string& name, Kind kind_a, Kind kind_b, double gap, bool is_warm) {
    return {name + (is_warm ? " warm" : " cold"), [=](int count, std::uint64_t seed) -> QueryRuns {
                const auto pairs = std::make_shared<DistancePairs>(random_pairs(kind_a, kind_b, gap, count, seed));
                return {[=] { return run_tumble(pairs->ours, is_warm); },
                        [=] { return run_box2d(pairs->theirs, is_warm); }};
            }};
}

// All pairs in one call.
QueryCase batch_case(const std::string& name, Kind kind, double gap) {
    return {name, [=](int count, std::uint64_t seed) -> QueryRuns {
                const auto pairs = std::make_shared<DistancePairs>(random_pairs(kind, kind, gap, count, seed));
                std::vector<PosedPair> posed;
                for (const Pair& pair : pairs->ours) posed.push_back({&pair.a, pair.pose_a, &pair.b, pair.pose_b});
                const auto results = std::make_shared<std::vector<DistanceResult>>(posed.size());
                return {[=] {
                            distance_batch(posed, *results);
                            double sum = 0.0;
                            for (const DistanceResult& result : *results) sum += result.distance;
                            return sum;
                        },
                        [=] { return run_box2d(pairs->theirs, false); }};
            }};
}

struct ManifoldPairs {
    std::vector<Pair> ours;
    struct Query {
        b2PolygonShape a, b;
        b2Transform pose_a, pose_b;
    };
    std::vector<Query> theirs;

    explicit ManifoldPairs(std::vector<Pair> pairs) : ours(std::move(pairs)) {
        for (const Pair& pair : ours) {
            Query& query = theirs.emplace_back();
            query.a.Set(vertices_of(pair.a).data(), pair.a.vertex_count());
            query.b.Set(vertices_of(pair.b).data(), pair.b.vertex_count());
            query.pose_a = to_b2(pair.pose_a);
            query.pose_b = to_b2(pair.pose_b);
        }
    }
};

// b2CollidePolygons has no cache: its time is the same for both.
QueryCase manifold_case(const std::string& name, Kind kind, double gap, bool is_warm) {
    return {name + (is_warm ? " warm" : " cold"), [=](int count, std::uint64_t seed) -> QueryRuns {
                const auto pairs = std::make_shared<ManifoldPairs>(random_pairs(kind, kind, gap, count, seed));
                return {
                    [=] {
                        double sum = 0.0;
                        for (Pair& pair : pairs->ours) {
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
                    }};
            }};
}

struct ImpactPairs {
    struct OurQuery {
        Shape a, b;
        Sweep sweep_a, sweep_b;
    };
    std::vector<OurQuery> ours;
    Proxies proxies;
    std::vector<b2TOIInput> theirs;

    ImpactPairs(const std::vector<Pair>& pairs, std::uint64_t seed) : proxies(vertex_total(pairs)) {
        for (std::size_t i = 0; i < pairs.size(); ++i) add(pairs[i], Random(~seed, i));
    }

private:
    // B comes by twice the gap along the normal, both turn.
    void add(const Pair& pair, Random random) {
        const DistanceResult start = distance(pair.a, pair.pose_a, pair.b, pair.pose_b);
        const DVec2 way = (-2.0 * start.distance) * start.normal;
        const auto sweep = [&](const Pose& pose, DVec2 motion) {
            return Sweep{{}, pose.position, pose.position + motion, angle(pose.rotation), random.uniform(-1.0, 1.0)};
        };
        const Sweep sweep_a = sweep(pair.pose_a, {}), sweep_b = sweep(pair.pose_b, way);
        ours.push_back({pair.a, pair.b, sweep_a, sweep_b});
        theirs.push_back({proxies.make(pair.a), proxies.make(pair.b), to_b2(sweep_a), to_b2(sweep_b), 1.0f});
    }
};

QueryCase impact_case(const std::string& name, Kind kind) {
    return {name, [=](int count, std::uint64_t seed) -> QueryRuns {
                const auto pairs = std::make_shared<ImpactPairs>(random_pairs(kind, kind, 0.5, count, seed), seed);
                return {[=] {
                            double sum = 0.0;
                            for (const ImpactPairs::OurQuery& query : pairs->ours)
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
                        }};
            }};
}

// From the place of the pair's second shape towards the first one's centre: each ray hits. Each engine's list holds
// what its query needs and no more, as reading it is a part of a query this short.
template <class B2Shape>
struct RayQueries {
    struct OurQuery {
        Shape shape;
        Pose pose;
        DVec2 origin, translation;
    };
    struct TheirQuery {
        B2Shape shape;
        b2Transform pose;
        b2RayCastInput input;
    };
    std::vector<OurQuery> ours;
    std::vector<TheirQuery> theirs;

    explicit RayQueries(const std::vector<Pair>& pairs) {
        for (const Pair& pair : pairs) {
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
QueryCase ray_case(const std::string& name, Kind kind) {
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
                        }};
            }};
}

}  // namespace

std::vector<QueryCase> query_cases() {
    struct Row {
        const char* name;
        Kind a, b;
        double gap;
    };
    constexpr double kNear = 0.01, kFar = 3.0, kDeep = -0.05, kResting = -0.005;
    const Row distances[] = {{"circle-circle", Kind::circle, Kind::circle, kNear},
                             {"circle-box near", Kind::circle, Kind::box, kNear},
                             {"capsule-capsule near", Kind::capsule, Kind::capsule, kNear},
                             {"box-box far", Kind::box, Kind::box, kFar},
                             {"box-box near", Kind::box, Kind::box, kNear},
                             {"box-box overlapping", Kind::box, Kind::box, kDeep},
                             {"8-gon near", Kind::octagon, Kind::octagon, kNear},
                             {"8-gon overlapping", Kind::octagon, Kind::octagon, kDeep}};
    std::vector<QueryCase> cases;
    for (const Row& row : distances)
        for (const bool is_warm : {false, true})
            cases.push_back(distance_case(row.name, row.a, row.b, row.gap, is_warm));
    cases.push_back(batch_case("box-box near batch", Kind::box, kNear));
    cases.push_back(batch_case("8-gon near batch", Kind::octagon, kNear));
    for (const bool is_warm : {false, true}) {
        cases.push_back(manifold_case("manifold box-box", Kind::box, kResting, is_warm));
        cases.push_back(manifold_case("manifold 8-gon", Kind::octagon, kResting, is_warm));
    }
    cases.push_back(impact_case("time of impact circles", Kind::circle));
    cases.push_back(impact_case("time of impact boxes", Kind::box));
    cases.push_back(impact_case("time of impact 8-gons", Kind::octagon));
    cases.push_back(ray_case<b2CircleShape>("ray circle", Kind::circle));
    cases.push_back(ray_case<b2PolygonShape>("ray box", Kind::box));
    cases.push_back(ray_case<b2PolygonShape>("ray 8-gon", Kind::octagon));
    cases.push_back(distance_case("1000-gon near", Kind::large, Kind::large, kNear, false));
    return cases;
}

}  // namespace tumble::reference
