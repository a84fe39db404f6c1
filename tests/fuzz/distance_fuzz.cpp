// libFuzzer target over the query interface: any vertices, poses, radii and caches. A query ends with a decided status.
// For convex shapes the bounds contain the distance, swapping the shapes changes nothing, and the bounds of a cold
// query, a warm one and the trace overlap.
#include <cmath>
#include <cstdlib>

#include "bytes.hpp"

using namespace tumble;

namespace {

void require(bool holds) {
    if (!holds) std::abort();
}

bool is_all_nan(const DistanceResult& result) {
    return std::isnan(result.distance) && std::isnan(result.lower) && std::isnan(result.upper);
}

bool same_bits_or_nan(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// True of the bounds of two answers to one query; of refused ones too.
bool overlap(const DistanceResult& one, const DistanceResult& other) {
    return one.status == DistanceStatus::invalid || (one.lower <= other.upper && other.lower <= one.upper);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Bytes bytes(data, size);
    const fuzz::FuzzedShape fuzzed_a = fuzz::take_shape(bytes), fuzzed_b = fuzz::take_shape(bytes);
    const Shape &a = fuzzed_a.shape, &b = fuzzed_b.shape;
    const Pose pose_a = fuzz::take_pose(bytes), pose_b = fuzz::take_pose(bytes);
    SimplexCache cache;
    cache.count = bytes.take<std::uint8_t>();
    for (VertexPair& pair : cache.pairs) pair = {bytes.take<std::uint16_t>(), bytes.take<std::uint16_t>()};

    const DistanceResult cold = distance(a, pose_a, b, pose_b);
    if (cold.status == DistanceStatus::invalid) {
        require(is_all_nan(cold));
    } else if (fuzzed_a.is_convex && fuzzed_b.is_convex) {
        require(cold.lower <= cold.upper);
        require(cold.lower <= cold.distance && cold.distance <= cold.upper);
        require((cold.status == DistanceStatus::separated) == (cold.lower > 0.0));
        require((cold.status == DistanceStatus::overlapping) == (cold.upper < 0.0));
    }
    const DistanceResult warm = distance(a, pose_a, b, pose_b, &cache);
    require((warm.status == DistanceStatus::invalid) == (cold.status == DistanceStatus::invalid));
    if (fuzzed_a.is_convex && fuzzed_b.is_convex) {
        require(same_bits_or_nan(distance(b, pose_b, a, pose_a).distance, cold.distance));
        require(overlap(warm, cold));
    }
    const DistanceTrace trace = trace_distance(a, pose_a, b, pose_b);
    require((trace.result.status == DistanceStatus::invalid) == (cold.status == DistanceStatus::invalid));
    if (fuzzed_a.is_convex && fuzzed_b.is_convex) require(overlap(trace.result, cold));
    return 0;
}
