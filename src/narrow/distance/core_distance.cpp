#include <limits>

#include "debug/check.hpp"
#include "narrow/distance/measure_cores.hpp"
#include "narrow/distance/witness.hpp"

namespace tumble {

namespace {

// By division, so that a direction along an axis gives a normal of exactly 1.
DVec2 quotient(DVec2 v, double divisor) { return {v.x / divisor, v.y / divisor}; }

// For cores that do not share a point.
CoreDistance separated_cores(const CorePair& pair, const GjkResult& gjk) {
    TUMBLE_CHECK(!gjk.closest.contains_origin);
    TUMBLE_CHECK(gjk.simplex.count >= 1);
    TUMBLE_CHECK(gjk.simplex.count <= 2);
    const Closest& closest = gjk.closest;
    const double length_of_direction = length(closest.direction);
    CoreDistance result;
    result.distance = gjk.simplex.count == 1 ? length_of_direction : closest.toward / length_of_direction;
    result.lower = std::min(result.distance, -gjk.height / length_of_direction) - error_bound(pair);
    result.upper = result.distance + error_bound(pair);
    result.direction = closest.direction;
    result.normal = quotient(closest.direction, length_of_direction);
    result.pairs[0] = gjk.simplex.vertices[0].pair();
    result.pairs[1] = gjk.simplex.vertices[gjk.simplex.count - 1].pair();
    result.pair_count = gjk.simplex.count;
    return result;
}

// Two points, or polygons without any edge: the result of GJK, with the normal (1, 0) if they coincide.
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
    TUMBLE_CHECK(face.direction != DVec2{});
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

// Within rounding of contact both are valid: GJK's simplex is an upper bound, the face a lower one. If the face gives
// the answer it is an upper bound too, because its distance from the origin is its depth.
CoreDistance touching_cores(const CorePair& pair, const GjkResult& gjk, const CoreDistance& by_face) {
    CoreDistance result = by_face;
    result.upper = std::abs(by_face.distance) + error_bound(pair);
    if (gjk.closest.contains_origin) return result;
    const CoreDistance by_gjk = separated_cores(pair, gjk);
    if (by_face.distance > 0.0) result = by_gjk;
    const CoreDistance& lower = by_face.lower >= by_gjk.lower ? by_face : by_gjk;
    result.lower = lower.lower;
    result.direction = lower.direction;
    return result;
}

// The answer for all cores that GJK does not prove to be separated: they overlap, or touch within rounding.
CoreDistance unseparated_cores(const CorePair& pair, const GjkResult& gjk) {
    const FoundFace deepest = deepest_face(pair);
    if (!deepest.exists) return touching_points(pair, gjk);
    const CoreDistance result = face_distance(pair, deepest.face);
    return result.overlap ? result : touching_cores(pair, gjk, result);
}

// For small cores: measures the feature that the simplex spans, by the formulas with which all their queries end.
bool measure_small_simplex(const CorePair& pair, const Simplex& simplex, CoreDistance& result) {
    TUMBLE_CHECK(simplex.count >= 1);
    if (simplex.count > 2 || !has_few_faces(pair)) return false;
    if (pair.a.count == 1 && pair.b.count == 1) return measure_points(pair, result) && result.lower > 0.0;
    const VertexPair first = simplex.vertices[0].pair(), second = simplex.vertices[1].pair();
    if (simplex.count == 1) return measure_by_vertex<8>(pair, {turn<8>(pair.a), turn<8>(pair.b)}, first, result);
    return measure_by_ends<8>(pair, first, second, result) || measure_by_ends<8>(pair, second, first, result);
}

CoreDistance measure_simplex(const CorePair& pair, const GjkResult& gjk) {
    CoreDistance result;
    if (gjk.closest.contains_origin) return unseparated_cores(pair, gjk);
    if (measure_small_simplex(pair, gjk.simplex, result)) return result;
    result = separated_cores(pair, gjk);
    return result.lower > 0.0 ? result : unseparated_cores(pair, gjk);
}

void find_witness(const CorePair& pair, CoreDistance& core) {
    const CoreWitness witness = core_witness(pair, core);
    core.on_a = witness.a;
    core.on_b = witness.b;
}

void move_below_origin(const CorePair& pair, CoreDistance& core) {
    Face face{core.direction, core.distance, {core.pairs[0], core.pairs[1]}};
    move_below_origin(pair, face);
    core.pairs[0] = face.pairs[0];
    core.pairs[1] = face.pairs[1];
    find_witness(pair, core);
}

// Parallel faces of both cores may all have the largest separation, but the origin may project onto one of them only.
// If the cores overlap, a walk along these faces finds the part that the origin projects onto.
bool measure_parallel_faces(const CorePair& pair, CoreDistance& result) {
    const TurnedPair<8> turned = {turn<8>(pair.a), turn<8>(pair.b)};
    for (LeadingFaces<8> leading(pair, turned); leading.bits != 0; leading.bits &= leading.bits - 1) {
        const Foot foot = measure_by_face(pair, leading.first(), result);
        if (result.overlap && foot != Foot::inside) move_below_origin(pair, result);
        if (result.overlap || (foot == Foot::inside && result.lower > 0.0)) return true;
    }
    return false;
}

}  // namespace

CoreDistance conclude(const CorePair& pair, GjkResult gjk) {
    CoreDistance result = measure_simplex(pair, gjk);
    // A face that separates disproves a triangle that rounding alone closed around the origin.
    if (gjk.closest.contains_origin && result.lower > 0.0) {
        gjk = exhaustive_search(pair, gjk);
        result = measure_simplex(pair, gjk);
    }
    TUMBLE_CHECK(result.pair_count >= 1);
    TUMBLE_CHECK(result.pair_count <= 2);
    TUMBLE_CHECK(!(result.lower > result.upper));
    // A shorter vector has a length that is not accurate: its squares underflow.
    TUMBLE_CHECK((!(result.distance > 0x1p-400) || std::abs(length_sq(result.normal) - 1.0) < 0x1p-40));
    find_witness(pair, result);
    result.iterations = gjk.iterations;
    result.reached_cap = gjk.reached_cap;
    return result;
}

CoreDistance search_small_cores(const CorePair& pair, SimplexCache* cache) {
    CoreDistance result;
    if (measure_parallel_faces(pair, result)) {
        result.iterations = 2;
    } else {
        result = measure_by_gjk<VoronoiRegions>(pair, nullptr, kUnobserved);
        result.iterations += 2;
    }
    if (cache) store(result, *cache);
    return result;
}

CoreDistance measure_any_cores(const CorePair& pair, SimplexCache* cache) {
    return measure_by_gjk<VoronoiRegions>(pair, cache, kUnobserved);
}

GjkResult exhaustive_search(const CorePair& pair, GjkResult stopped) {
    GjkResult result = stopped;
    result.simplex = nearest_simplex(pair);
    result.closest = VoronoiRegions::reduce(pair, result.simplex);
    result.height = std::numeric_limits<double>::infinity();  // nothing is proved yet
    return with_better_proof<VoronoiRegions>(pair, result, result.simplex, result.closest, kUnobserved);
}

}  // namespace tumble
