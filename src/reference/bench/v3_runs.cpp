#include "reference/bench/v3_runs.hpp"

#include <memory>

#include "reference/box2d_v3/library/v3_library.hpp"
#include "reference/box2d_v3/v3_queries.hpp"

namespace tumble::reference {

namespace {

namespace v3 = box2d_v3;

// The points of all shapes of a list, while the library converts them.
class PointsOfList {
public:
    explicit PointsOfList(std::size_t shapes) { all_.reserve(shapes); }

    v3::Points add(const Shape& shape) {
        all_.emplace_back(shape);
        fit_ = fit_ && all_.back().fits();
        return all_.back().get();
    }
    bool fit() const { return fit_; }

private:
    std::vector<V3Points> all_;
    bool fit_ = true;
};

QueryRun run_of(v3::Queries* list) {
    const std::shared_ptr<v3::Queries> queries(list);
    return [=] { return queries->run(); };
}

v3::Place place_of(const Pose& pose) {
    const Vec2 position = to_float(pose.position);
    return {position.x, position.y, pose.rotation.c, pose.rotation.s};
}

// The pairs for the library; none if a shape does not fit.
std::vector<v3::PosedPair> posed_pairs(const std::vector<BenchPair>& pairs, PointsOfList& points) {
    std::vector<v3::PosedPair> posed;
    for (const BenchPair& pair : pairs)
        posed.push_back({points.add(pair.a), place_of(pair.pose_a), points.add(pair.b), place_of(pair.pose_b)});
    return posed;
}

}  // namespace

QueryRun v3_distances(const std::vector<BenchPair>& pairs, bool is_warm) {
    if (!has_box2d_v3()) return {};
    PointsOfList points(2 * pairs.size());
    const std::vector<v3::PosedPair> posed = posed_pairs(pairs, points);
    return points.fit() ? run_of(v3::make_distances(posed, is_warm)) : QueryRun{};
}

QueryRun v3_manifolds(const std::vector<BenchPair>& pairs) {
    if (!has_box2d_v3()) return {};
    PointsOfList points(2 * pairs.size());
    const std::vector<v3::PosedPair> posed = posed_pairs(pairs, points);
    return points.fit() ? run_of(v3::make_manifolds(posed)) : QueryRun{};
}

QueryRun v3_impacts(const std::vector<BenchImpact>& impacts) {
    if (!has_box2d_v3()) return {};
    PointsOfList points(2 * impacts.size());
    std::vector<v3::MovingPair> moving;
    for (const BenchImpact& pair : impacts)
        moving.push_back({points.add(pair.a), v3_motion(pair.sweep_a), points.add(pair.b), v3_motion(pair.sweep_b)});
    return points.fit() ? run_of(v3::make_impacts(moving)) : QueryRun{};
}

QueryRun v3_rays(const std::vector<BenchRay>& rays) {
    if (!has_box2d_v3()) return {};
    PointsOfList points(rays.size());
    std::vector<v3::Ray> all;
    for (const BenchRay& ray : rays) {
        const Vec2 origin = to_float(ray.origin), along = to_float(ray.translation);
        all.push_back({points.add(ray.shape), place_of(ray.pose), origin.x, origin.y, along.x, along.y});
    }
    return points.fit() ? run_of(v3::make_rays(all)) : QueryRun{};
}

}  // namespace tumble::reference
