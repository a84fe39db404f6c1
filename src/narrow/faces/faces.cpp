#include "narrow/faces/faces.hpp"

#include <algorithm>

#include "debug/check.hpp"
#include "narrow/cores/error_bound.hpp"
#include "narrow/faces/leading_faces.hpp"

namespace tumble {

namespace {

FoundFace make_face(const CorePair& pair, DVec2 direction, double height_a, double height_b, VertexPair first,
                    VertexPair second) {
    TUMBLE_CHECK((first.a == second.a || first.b == second.b));
    const double length_of_direction = length(direction);
    const double height = (height_a + height_b) - dot(direction, pair.offset);
    return {{direction, -height / length_of_direction, {first, second}}, length_of_direction > 0.0};
}

void keep_deeper(FoundFace& best, const FoundFace& other) {
    if (other.exists && (!best.exists || other.face.separation > best.face.separation)) best = other;
}

double height(const CorePair& pair, DVec2 direction, VertexPair at) {
    return dot(direction, minkowski_vertex(pair, at).w);
}

// The next vertex of A - B around its outline, counter-clockwise for step 1: the step of A or of B that falls less.
VertexPair neighbour(const CorePair& pair, DVec2 direction, VertexPair at, int step) {
    const auto beside = [step](const Core& core, int i) { return step > 0 ? core.next(i) : core.previous(i); };
    const VertexPair along_a = make_pair_of(beside(pair.a, at.a), at.b),
                     along_b = make_pair_of(at.a, beside(pair.b, at.b));
    if (along_a == at) return along_b;
    if (along_b == at) return along_a;
    return height(pair, direction, along_a) >= height(pair, direction, along_b) ? along_a : along_b;
}

// An edge's outward normal, as long as it, and from A to B also for edges of B.
DVec2 normal_of_a(const CorePair& pair, int edge) { return -perp(pair.a.edge(edge, pair.a.next(edge))); }
DVec2 normal_of_b(const CorePair& pair, int edge) { return perp(pair.b.edge(edge, pair.b.next(edge))); }

// The height of an edge in the direction of its normal. If the outline is not convex, other vertices may be higher:
// then the height of the core, so that the separation stays a lower bound.
double own_height(const Core& core, int edge, DVec2 outward) {
    return core.is_convex ? dot(outward, core.point(edge)) : support(core, outward).height;
}

FoundFace face_of_a(const CorePair& pair, int edge, DVec2 direction, Support b) {
    const double height_a = own_height(pair.a, edge, direction);
    return make_face(pair, direction, height_a, b.height, make_pair_of(edge, b.index),
                     make_pair_of(pair.a.next(edge), b.index));
}

FoundFace face_of_b(const CorePair& pair, int edge, DVec2 direction, Support a) {
    const double height_b = own_height(pair.b, edge, -direction);
    return make_face(pair, direction, a.height, height_b, make_pair_of(a.index, edge),
                     make_pair_of(a.index, pair.b.next(edge)));
}

}  // namespace

FoundFace face_of_a(const CorePair& pair, int edge) {
    TUMBLE_CHECK(edge >= 0);
    TUMBLE_CHECK(edge < pair.a.count);
    const DVec2 direction = normal_of_a(pair, edge);
    return face_of_a(pair, edge, direction, support(pair.b, -direction));
}

FoundFace face_of_b(const CorePair& pair, int edge) {
    TUMBLE_CHECK(edge >= 0);
    TUMBLE_CHECK(edge < pair.b.count);
    const DVec2 direction = normal_of_b(pair, edge);
    return face_of_b(pair, edge, direction, support(pair.a, direction));
}

// Walks along the outline towards the origin's foot, as long as the outline, or its part up to the foot, stays level
// within the rounding of heights.
void move_below_origin(const CorePair& pair, Face& face) {
    TUMBLE_CHECK(face.pairs[0].a < pair.a.count);
    TUMBLE_CHECK(face.pairs[0].b < pair.b.count);
    const DVec2 along = perp(face.direction);  // from the first pair to the second
    const double slack = progress_bound(pair) * length(face.direction);
    const double level = height(pair, face.direction, face.pairs[0]) - slack;
    const int step = dot(minkowski_vertex(pair, face.pairs[1]).w, along) < 0.0 ? 1 : -1;
    const int far = step > 0 ? 1 : 0;
    const auto distance_to_go = [&](VertexPair at) { return -step * dot(minkowski_vertex(pair, at).w, along); };
    for (int steps = pair.a.count + pair.b.count; steps > 0; --steps) {
        const VertexPair end = face.pairs[far];
        const double to_go = distance_to_go(end);
        if (!(to_go > 0.0)) return;
        const VertexPair next = neighbour(pair, face.direction, end, step);
        const double left = distance_to_go(next);
        const double part = left < 0.0 ? to_go / (to_go - left) : 1.0;
        TUMBLE_CHECK(part >= 0.0);  // 0 where the quotient underflows
        TUMBLE_CHECK(part <= 1.0);
        const double from = height(pair, face.direction, end), to = height(pair, face.direction, next);
        if (next == end || from + part * (to - from) < level) return;
        face.pairs[1 - far] = end;
        face.pairs[far] = next;
    }
}

namespace {

template <int N>
FoundFace deepest_face_in_lanes(const CorePair& pair) {
    const TurnedPair<N> turned = {turn<N>(pair.a), turn<N>(pair.b)};
    const LeadingFaces<N> leading(pair, turned);
    if (leading.bits == 0) return {};
    const OwnedFace face = leading.first();
    TUMBLE_CHECK(face.from != face.to);
    const double sign = kSign[face.is_b];
    return {{{sign * face.numbers.outward_x, sign * face.numbers.outward_y},
             face.numbers.separation,
             {pair_of_owner(face.is_b, face.from, face.nearest), pair_of_owner(face.is_b, face.to, face.nearest)}},
            true};
}

// The supports of a core for directions that turn with the edges of the other core: each is near the one before.
class SupportsAround {
public:
    explicit SupportsAround(const Core& core) : core_(core) {}

    Support operator()(DVec2 direction) {
        const Support found = support(core_, direction, near_);
        near_ = found.index;
        return found;
    }

private:
    const Core& core_;
    int near_ = 0;
};

FoundFace deepest_face_one_by_one(const CorePair& pair) {
    FoundFace best;
    SupportsAround of_b(pair.b), of_a(pair.a);
    for (int edge = 0; edge < pair.a.count && pair.a.count > 1; ++edge) {
        const DVec2 direction = normal_of_a(pair, edge);
        keep_deeper(best, face_of_a(pair, edge, direction, of_b(-direction)));
    }
    for (int edge = 0; edge < pair.b.count && pair.b.count > 1; ++edge) {
        const DVec2 direction = normal_of_b(pair, edge);
        keep_deeper(best, face_of_b(pair, edge, direction, of_a(direction)));
    }
    return best;
}

}  // namespace

FoundFace deepest_face(const CorePair& pair) {
    FoundFace deepest = has_few_faces(pair) ? deepest_face_in_lanes<8>(pair) : deepest_face_one_by_one(pair);
    if (deepest.exists) move_below_origin(pair, deepest.face);
    return deepest;
}

}  // namespace tumble
