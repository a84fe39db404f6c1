// Witness points of the cores from the closest feature: on one core its vertex, on the other the point at the distance
// along the normal.
#pragma once

#include "debug/check.hpp"
#include "narrow/distance/core_distance.hpp"

namespace tumble {

// Relative to A's and to B's position, each in world axes.
struct CoreWitness {
    DVec2 a;
    DVec2 b;
};

inline CoreWitness core_witness(const CorePair& pair, const CoreDistance& core) {
    TUMBLE_CHECK(core.pair_count >= 1);
    const VertexPair first = core.pairs[0], second = core.pairs[1];
    const DVec2 a = pair.a.point(first.a), b = pair.b.point(first.b);
    if (core.pair_count == 1) return {a, b};
    const DVec2 apart = core.distance * core.normal;
    if (first.b == second.b) return {(b + pair.offset) - apart, b};
    if (first.a == second.a) return {a, (a - pair.offset) + apart};
    // Parallel edges: the point of A's edge at the parameter of the point of A - B nearest to the origin.
    const DVec2 along_a = pair.a.edge(first.a, second.a), along_b = pair.b.edge(first.b, second.b);
    const DVec2 w = (a - b) - pair.offset, edge = along_a - along_b;
    const double parameter = std::clamp(-dot(w, edge) / length_sq(edge), 0.0, 1.0);
    const DVec2 on_a = a + parameter * along_a;
    TUMBLE_CHECK(!(parameter < 0.0));
    TUMBLE_CHECK(!(parameter > 1.0));
    return {on_a, (on_a - pair.offset) + apart};
}

}  // namespace tumble
