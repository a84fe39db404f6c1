#include "narrow/core_distance.hpp"

namespace tumble {

namespace {

// Two points, or polygons without any edge: what GJK found, and a normal decided where they coincide.
CoreDistance touching_points(const CorePair& pair, const GjkResult& gjk) {
    if (!gjk.closest.contains_origin) return separated_cores(pair, gjk);
    CoreDistance result;
    result.lower = -error_bound(pair);
    result.upper = error_bound(pair);
    result.direction = result.normal = {1.0, 0.0};
    result.pairs[0] = gjk.simplex.vertices[0].pair();
    result.pair_count = 1;
    return result;
}

CoreDistance face_distance(const CorePair& pair, const Face& face) {
    CoreDistance result;
    result.distance = face.separation;
    result.lower = face.separation - error_bound(pair);
    result.upper = face.separation + error_bound(pair);
    result.direction = face.direction;
    result.normal = quotient(face.direction, length(face.direction));
    result.pairs[0] = face.pairs[0];
    result.pairs[1] = face.pairs[1];
    result.pair_count = 2;
    result.overlap = result.upper < 0.0;
    return result;
}

// Within rounding of contact both views are true: GJK's simplex bounds from above, the face from below.
CoreDistance touching_cores(const CorePair& pair, const GjkResult& gjk, const CoreDistance& by_face) {
    if (gjk.closest.contains_origin) {
        CoreDistance result = by_face;
        result.upper = std::max(result.distance, error_bound(pair));
        return result;
    }
    const CoreDistance by_gjk = separated_cores(pair, gjk);
    CoreDistance result = by_face.distance > 0.0 ? by_gjk : by_face;
    if (by_face.lower >= by_gjk.lower) {
        result.lower = by_face.lower;
        result.direction = by_face.direction;
    } else {
        result.lower = by_gjk.lower;
        result.direction = by_gjk.direction;
    }
    result.upper = by_gjk.upper;
    return result;
}

}  // namespace

CoreDistance unseparated_cores(const CorePair& pair, GjkResult gjk) {
    const FoundFace deepest = deepest_face(pair);
    CoreDistance result;
    if (!deepest.exists) {
        result = touching_points(pair, gjk);
    } else {
        result = face_distance(pair, deepest.face);
        if (!result.overlap) result = touching_cores(pair, gjk, result);
    }
    result.iterations = gjk.iterations;
    result.reached_cap = gjk.reached_cap;
    return result;
}

GjkResult exhaustive_search(const CorePair& pair, GjkResult stopped) {
    GjkResult result = stopped;
    result.simplex = nearest_simplex(pair);
    result.closest = VoronoiRegions::reduce(pair, result.simplex);
    if (!result.closest.contains_origin) result.height = support(pair, result.closest.direction).height;
    return result;
}

}  // namespace tumble
