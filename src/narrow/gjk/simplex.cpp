#include "narrow/gjk/simplex.hpp"

namespace tumble {

DVec2 short_edge_between(const CorePair& pair, VertexPair from, VertexPair to) {
    if (from.b == to.b) return pair.a.edge(from.a, to.a);
    if (from.a == to.a) return -pair.b.edge(from.b, to.b);
    return minkowski_vertex(pair, to).w - minkowski_vertex(pair, from).w;
}

}  // namespace tumble
