// Support mappings: the farthest vertex of a core, and of the Minkowski difference A - B, in a direction [GJK88].
#pragma once

#include "debug/check.hpp"
#include "narrow/cores/large_support.hpp"
#include "tumble/distance.hpp"

namespace tumble {

struct Support {
    int index;
    double height;  // direction . vertex, relative to the body's position
};

[[gnu::always_inline]] inline Support support_at(const Core& core, DVec2 local, int index) {
    TUMBLE_CHECK(index >= 0);
    TUMBLE_CHECK(index < core.count);
    return {index, local.x * core.x[index] + local.y * core.y[index]};
}

[[gnu::always_inline]] inline bool has_edge_angles(const Core& core) { return core.large && core.is_convex; }

// The support vertex in a direction. Of equally high vertices the one with the lowest index; of a large polygon any.
// `near` is a vertex of a large polygon that is likely to be near the support.
[[gnu::always_inline]] inline Support support(const Core& core, DVec2 direction, int near = 0) {
    const DVec2 local = core.turned_back(direction);  // turning the direction is cheaper than turning all vertices
    if (has_edge_angles(core)) return support_at(core, local, large_support(*core.large, local, near));
    Support best = support_at(core, local, 0);
    for (int i = 1; i < core.count; ++i) {
        const Support other = support_at(core, local, i);
        best.index = other.height > best.height ? i : best.index;
        best.height = other.height > best.height ? other.height : best.height;
    }
    return best;
}

[[gnu::always_inline]] inline VertexPair make_pair_of(int a, int b) {
    TUMBLE_CHECK(a >= 0);
    TUMBLE_CHECK(b >= 0);
    return {static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(b)};
}

// The same by the owner of the first index: 0 for A, 1 for B. By shifts, since a branch on the owner would be
// mispredicted half the time.
[[gnu::always_inline]] inline VertexPair pair_of_owner(unsigned is_b, int own, int other) {
    TUMBLE_CHECK(is_b <= 1u);
    const unsigned shift = 16 * is_b;
    const unsigned key = static_cast<unsigned>(own) << shift | static_cast<unsigned>(other) << (16 - shift);
    return {static_cast<std::uint16_t>(key), static_cast<std::uint16_t>(key >> 16)};
}

[[gnu::always_inline]] inline int own_vertex(unsigned is_b, VertexPair pair) {
    TUMBLE_CHECK(is_b <= 1u);
    return static_cast<int>((pair.a | static_cast<unsigned>(pair.b) << 16) >> (16 * is_b) & 0xffff);
}

// A vertex w = a - b of the Minkowski difference A - B, relative to the origin.
struct MinkowskiVertex {
    DVec2 w;
    std::uint32_t key;  // both indices in one register

    VertexPair pair() const { return {static_cast<std::uint16_t>(key >> 16), static_cast<std::uint16_t>(key)}; }
};

[[gnu::always_inline]] inline MinkowskiVertex minkowski_vertex(const CorePair& pair, VertexPair at) {
    return {(pair.a.point(at.a) - pair.b.point(at.b)) - pair.offset, static_cast<std::uint32_t>(at.a) << 16 | at.b};
}

struct MinkowskiSupport {
    MinkowskiVertex vertex;
    double height;  // direction . w, from the heights of the two supports
};

[[gnu::always_inline]] inline MinkowskiSupport support(const CorePair& pair, DVec2 direction, VertexPair near = {}) {
    const Support a = support(pair.a, direction, near.a);
    const Support b = support(pair.b, -direction, near.b);
    const VertexPair at{static_cast<std::uint16_t>(a.index), static_cast<std::uint16_t>(b.index)};
    return {minkowski_vertex(pair, at), (a.height + b.height) - dot(direction, pair.offset)};
}

}  // namespace tumble
