// gjk_distance() and trace_distance(): the GJK loop alone, with any distance subalgorithm, and with an observer that
// records every iteration.
#include <limits>

#include "debug/check.hpp"
#include "narrow/distance/distance_result.hpp"
#include "narrow/gjk/johnson.hpp"
#include "narrow/gjk/signed_volumes.hpp"

namespace tumble {

namespace {

class Recorder {
public:
    Recorder(const CorePair& pair, std::vector<TraceStep>& steps) : pair_(pair), steps_(steps) {}

    void operator()(const Simplex& simplex, const Closest& closest, const MinkowskiSupport& support) {
        const double length_of_direction = length(closest.direction);
        TUMBLE_CHECK(length_of_direction > 0.0);
        TraceStep step;
        step.count = static_cast<std::uint8_t>(simplex.count);
        for (std::size_t i = 0; i < step.count; ++i) {
            step.simplex[i] = simplex.vertices[i].pair();
            step.vertices[i] = simplex.vertices[i].w;
        }
        step.closest = (-closest.toward / length_sq(closest.direction)) * closest.direction;
        step.direction = closest.direction;
        step.support = support.vertex.pair();
        step.support_vertex = support.vertex.w;
        lower_ = std::max(lower_, -support.height / length_of_direction - error_bound(pair_));
        step.lower = lower_;
        upper_ = std::min(upper_, closest.toward / length_of_direction + error_bound(pair_));
        step.upper = upper_;
        steps_.push_back(step);
    }

private:
    const CorePair& pair_;
    std::vector<TraceStep>& steps_;
    double upper_ = std::numeric_limits<double>::infinity(), lower_ = -upper_;
};

// Chooses the subalgorithm once, outside the loop.
template <typename Observer>
CoreDistance measure_by(SubAlgorithm sub_algorithm, const CorePair& pair, SimplexCache* cache, Observer&& observe) {
    switch (sub_algorithm) {
        case SubAlgorithm::voronoi: break;
        case SubAlgorithm::johnson: return measure_by_gjk<Johnson>(pair, cache, observe);
        case SubAlgorithm::signed_volumes: return measure_by_gjk<SignedVolumes>(pair, cache, observe);
    }
    return measure_by_gjk<VoronoiRegions>(pair, cache, observe);
}

}  // namespace

DistanceResult gjk_distance(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                            SubAlgorithm sub_algorithm, SimplexCache* cache) noexcept {
    const CorePair pair = make_core_pair(a, world_from_a, b, world_from_b);
    if (!is_valid(pair, a, b)) return invalid_result();
    const CoreDistance core = measure_by(sub_algorithm, pair, cache, kUnobserved);
    return make_result(core, a, b, world_from_a.position, world_from_b.position);
}

DistanceTrace trace_distance(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                             SubAlgorithm sub_algorithm) {
    DistanceTrace trace;
    const CorePair pair = make_core_pair(a, world_from_a, b, world_from_b);
    if (!is_valid(pair, a, b)) {
        trace.result = invalid_result();
        return trace;
    }
    const CoreDistance core = measure_by(sub_algorithm, pair, nullptr, Recorder(pair, trace.steps));
    trace.result = make_result(core, a, b, world_from_a.position, world_from_b.position);
    return trace;
}

}  // namespace tumble
