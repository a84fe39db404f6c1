#include "narrow/faces.hpp"

namespace tumble {

namespace {

FoundFace make_face(const CorePair& pair, DVec2 direction, double height_a, double height_b, VertexPair first,
                    VertexPair second) {
    const double length_of_direction = length(direction);
    const double height = (height_a + height_b) - dot(direction, pair.offset);
    return {{direction, -height / length_of_direction, {first, second}}, length_of_direction > 0.0};
}

VertexPair make_pair_of(int a, int b) { return {static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(b)}; }

void keep_deeper(FoundFace& best, const FoundFace& other) {
    if (other.exists && (!best.exists || other.face.separation > best.face.separation)) best = other;
}

}  // namespace

FoundFace face_of_a(const CorePair& pair, int edge) {
    const int next = pair.a.next(edge);
    const DVec2 direction = -perp(pair.a.edge(edge, next));
    const Support b = support(pair.b, -direction);
    const double height_a = dot(direction, pair.a.point(edge));
    return make_face(pair, direction, height_a, b.height, make_pair_of(edge, b.index), make_pair_of(next, b.index));
}

FoundFace face_of_b(const CorePair& pair, int edge) {
    const int next = pair.b.next(edge);
    const DVec2 direction = perp(pair.b.edge(edge, next));
    const Support a = support(pair.a, direction);
    const double height_b = -dot(direction, pair.b.point(edge));
    return make_face(pair, direction, a.height, height_b, make_pair_of(a.index, edge), make_pair_of(a.index, next));
}

FoundFace deepest_face(const CorePair& pair) {
    FoundFace best;
    for (int edge = 0; edge < pair.a.count && pair.a.count > 1; ++edge) keep_deeper(best, face_of_a(pair, edge));
    for (int edge = 0; edge < pair.b.count && pair.b.count > 1; ++edge) keep_deeper(best, face_of_b(pair, edge));
    return best;
}

}  // namespace tumble
