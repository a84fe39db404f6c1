#include "narrow/simplex.hpp"

namespace tumble {

DVec2 short_edge_between(const CorePair& pair, const MinkowskiVertex& from, const MinkowskiVertex& to) {
    if (from.pair.b == to.pair.b) return pair.a.edge(from.pair.a, to.pair.a);
    if (from.pair.a == to.pair.a) return -pair.b.edge(from.pair.b, to.pair.b);
    return to.w - from.w;
}

}  // namespace tumble
