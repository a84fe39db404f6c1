// Clipping: the edge of one core that faces a reference edge of the other, cut to the reference edge's length.
#pragma once

#include <algorithm>

#include "debug/check.hpp"
#include "narrow/cores/support.hpp"
#include "tumble/manifold.hpp"

namespace tumble {

// The core that owns the reference edge and the incident core, both relative to the owner's position.
struct ClipInput {
    const Core& reference;
    const Core& incident;
    DVec2 shift;       // from the reference's position to the incident's
    int edge;          // of the reference, by its first vertex
    int nearest;       // the incident core's vertex nearest to the reference edge's line; -1 if it is not known
    DVec2 normal;      // of the reference edge, unit; set if `nearest` is known
    double tolerance;  // the nearest vertex is not cut off if that would raise the separation by more (m)
};

struct ClippedPoint {
    DVec2 position;           // on the incident core, relative to the reference's position
    double separation = 0.0;  // of the cores along the normal
    int reference_vertex = 0;
    int incident_vertex = 0;
};

// In the counter-clockwise order of the reference edge; at least one point.
struct ClippedEdge {
    DVec2 normal;  // unit, out of the reference
    ClippedPoint points[2];
    int count = 0;
};

// The one of the two edges at a vertex whose outward normal points more against `normal`; by its first vertex.
[[gnu::always_inline]] inline int facing_edge(const Core& core, int vertex, DVec2 normal) {
    const int before = core.previous(vertex), after = core.next(vertex);
    const DVec2 edge_in = core.edge(before, vertex), edge_out = core.edge(vertex, after);
    // Cosines times lengths. Squared with their signs and cross-multiplied they compare without roots.
    const double in = cross(edge_in, normal), out = cross(edge_out, normal);
    return in * std::abs(in) * length_sq(edge_out) > out * std::abs(out) * length_sq(edge_in) ? before : vertex;
}

[[gnu::always_inline]] inline ClippedEdge clip(const ClipInput& input) {
    const Core& reference = input.reference;
    const Core& incident = input.incident;
    const int first = input.edge, second = reference.next(first);
    const DVec2 origin = reference.point(first), along = reference.edge(first, second);
    TUMBLE_CHECK(input.edge >= 0);
    TUMBLE_CHECK(input.edge < reference.count);
    TUMBLE_CHECK(input.nearest < incident.count);
    // Beside a shape of 1e16 times its size, rounding may turn the normal of an edge around: it is not used then.
    const bool is_known = input.nearest >= 0 && dot(along, perp(input.normal)) > 0.0;
    const DVec2 tangent = is_known ? perp(input.normal) : (1.0 / length(along)) * along;
    const DVec2 normal = -perp(tangent);
    const double side = dot(along, tangent);
    TUMBLE_CHECK(side > 0.0);
    const DVec2 shift = input.shift - origin;

    const auto point_at = [&](DVec2 relative, int reference_vertex, int incident_vertex) {
        return ClippedPoint{relative + origin, dot(relative, normal), reference_vertex, incident_vertex};
    };
    TUMBLE_CHECK(input.tolerance >= 0.0);
    ClippedEdge result;
    result.normal = normal;
    const int nearest = is_known ? input.nearest : support(incident, -normal).index;
    if (incident.count > 1) {
        // The incident edge runs against the reference edge: it ends low along the tangent.
        const int high = facing_edge(incident, nearest, normal), low = incident.next(high);
        const DVec2 from = incident.point(low) + shift, to = incident.point(high) + shift;
        const double along_from = dot(from, tangent), along_to = dot(to, tangent), run = along_to - along_from;
        if (run > 0.0 && along_from < side && along_to > 0.0) {
            const DVec2 edge = to - from;
            const auto cut = [&](DVec2 end, double by, int vertex) {
                const bool lifts = std::abs(by * dot(edge, normal)) > input.tolerance;
                return vertex == nearest && lifts ? end : end + by * edge;
            };
            const double cut_low = std::max(0.0, -along_from / run), cut_high = std::max(0.0, (along_to - side) / run);
            result.points[result.count++] = point_at(cut(from, cut_low, low), first, low);
            result.points[result.count++] = point_at(cut(to, -cut_high, high), second, high);
            return result;
        }
    }
    result.points[result.count++] = point_at(incident.point(nearest) + shift, first, nearest);
    return result;
}

}  // namespace tumble
