// Signed distance between two shapes by the Gilbert-Johnson-Keerthi algorithm, with a proof.
//
// Everything is computed and answered in double, in world axes relative to A's position, which keeps the answer
// bit-exact under swapping the shapes, exact translations, powers of two and quarter turns. There is no absolute
// tolerance: scaling the input by 2^k scales the answer bit for bit.
//
// Sources: Gilbert, Johnson, Keerthi 1988 [GJK88]; van den Bergen 1999, 2004 [vdB99, vdB04]; Ericson, Real-Time
// Collision Detection, 2004, 9.5 [Eri04]; Montanari, Petrinic, Barbieri 2017 [MPB17].
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble {

// One of the two shapes of a query.
enum class Side : std::uint8_t { none, a, b };

// A vertex of the Minkowski difference A - B, by its core vertices: w = a - b in world axes.
struct VertexPair {
    std::uint16_t a = 0;
    std::uint16_t b = 0;

    friend constexpr bool operator==(VertexPair, VertexPair) = default;
};

// The simplex that a query ended with, to start the next query between the same shapes. It is empty (count 0) if cores
// of at most eight vertices are not proved to be separated. Any content is safe: indices are range-checked, and a wrong
// hint costs iterations only. The reference edge is for manifolds alone: the edge that the last one was clipped
// against.
struct SimplexCache {
    std::array<VertexPair, 3> pairs{};
    std::uint8_t count = 0;
    Side reference_side = Side::none;
    std::uint16_t reference_edge = 0;  // by its first vertex
    std::uint16_t iterations = 0;      // of the last manifold's distance query, to be counted
    float distance = 0.0f;             // of the surfaces when the last manifold was found, m; 0 for invalid input
};

enum class DistanceStatus : std::uint8_t {
    separated,    // proved: lower > 0
    touching,     // the bounds straddle zero: the sign is below what double arithmetic can decide
    overlapping,  // proved: upper < 0
    invalid,      // NaN or infinity in the input, a shape without vertices, a negative radius, or positions more than
                  // 2^500 m apart (or, for points, less than 2^-480 m but not 0); every number of the result is NaN
};

// "separated", "touching", "overlapping" or "invalid".
constexpr std::string_view to_string(DistanceStatus status) {
    switch (status) {
        case DistanceStatus::separated: return "separated";
        case DistanceStatus::touching: return "touching";
        case DistanceStatus::overlapping: return "overlapping";
        case DistanceStatus::invalid: break;
    }
    return "invalid";
}

// The proof of the result for a checker in exact arithmetic. `direction` is any nonzero vector in world axes; with h
// the maximum of direction . w over all w of the core difference A - B, the signed core distance is at least -h /
// |direction|: this one inequality proves `lower`, separated or overlapping. The one or two pairs span the closest
// simplex of separated cores: its distance from the origin proves `upper`. For overlapping cores they are the face of A
// - B nearest to the origin (an edge of one shape and the support vertex of the other), and `upper` needs all faces.
struct Certificate {
    DVec2 direction;
    std::array<VertexPair, 2> pairs{};
    std::uint8_t pair_count = 0;
    bool cores_overlap = false;
};

struct DistanceResult {
    double distance = 0.0;  // signed, radii subtracted: negative inside (m)
    double lower = 0.0;     // the exact signed distance lies in [lower, upper]
    double upper = 0.0;
    DVec2 point_a;  // witness points on the surfaces, world coordinates:
    DVec2 point_b;  // point_b - point_a = distance * normal up to rounding, also inside
    DVec2 normal;   // unit, from A to B; (1, 0) if the cores coincide in a point
    Certificate certificate;
    DistanceStatus status = DistanceStatus::invalid;
    std::uint16_t iterations = 0;  // 1 for two points or a cached feature, 2 for all faces at once, else support pairs
    bool reached_cap = false;      // GJK stopped at its iteration bound and the exhaustive search answered
};

// The signed distance of two shapes. Does not throw or allocate. With a cache, the query starts from its simplex and
// stores the final one. A cache does not change the status, and where the closest pair is unique not a bit of the
// distance; elsewhere the bounds with and without it overlap. For shapes of at most eight vertices all faces of their
// difference are evaluated at once, in lanes: the face of largest separation decides overlap and depth, and the nearest
// point lies in it or at its end. GJK answers for more vertices (4 to 18 iterations of O(log n), O(n) if the outline is
// not strictly convex), and if rounding leaves the faces undecided.
//
// The bounds hold for the shapes as they are. make_polygon() welds nearby points, so for bounds that must hold for
// given points make the shape by make_exact_polygon().
DistanceResult distance(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                        SimplexCache* cache = nullptr) noexcept;

// A query of a batch. The shapes are the caller's, are not null and must outlive the call.
struct PosedPair {
    const Shape* a = nullptr;
    Pose world_from_a;
    const Shape* b = nullptr;
    Pose world_from_b;
};

// results[i] is distance() of pairs[i], bit for bit, whatever the other pairs and their order; as many as the shorter
// of the spans has. Pairs of convex shapes of up to eight vertices are computed in lanes, one pair in each: with
// AVX-512 in 60 % of the time of single queries for boxes, 67 % for octagons. Does not throw or allocate.
void distance_batch(std::span<const PosedPair> pairs, std::span<DistanceResult> results) noexcept;

// The method that finds the point of a simplex nearest to the origin. Their results differ by rounding only.
enum class SubAlgorithm : std::uint8_t {
    voronoi,         // by the regions of its vertices and edges [Eri04, 5.1.5]; the fastest, and what distance() uses
    johnson,         // by recursive cofactors, with the backup procedure [GJK88]
    signed_volumes,  // by the signs of lengths and areas [MPB17]
};

// The same query by the GJK loop alone, for any number of vertices. The same bits as distance() if the closest pair is
// unique, except for the iterations and the certificate, since several certificates may prove one distance. Does not
// throw or allocate.
DistanceResult gjk_distance(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                            SubAlgorithm sub_algorithm = SubAlgorithm::voronoi, SimplexCache* cache = nullptr) noexcept;

// One iteration of the loop, to be drawn or read. Vectors are in world axes, relative to A's position.
struct TraceStep {
    std::array<VertexPair, 3> simplex{};  // before the new support is added
    std::array<DVec2, 3> vertices{};      // their w
    std::uint8_t count = 0;
    DVec2 closest;       // the point of the simplex nearest to the origin
    DVec2 direction;     // the next search direction, towards the origin
    VertexPair support;  // the support found in it
    DVec2 support_vertex;
    double lower = 0.0;  // bounds on the core distance known after this step; lower may be negative
    double upper = 0.0;
};

struct DistanceTrace {
    std::vector<TraceStep> steps;
    DistanceResult result;
};

// gjk_distance() with every iteration of GJK recorded; allocates. The first support, towards the other shape, is the
// simplex of the first step, and counts. Iterations of an exhaustive search, if one answers, count but are no steps.
DistanceTrace trace_distance(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                             SubAlgorithm sub_algorithm = SubAlgorithm::voronoi);

}  // namespace tumble
