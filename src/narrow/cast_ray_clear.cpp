#include <bit>

#include "narrow/cast_circle.hpp"
#include "narrow/cast_ray.hpp"

namespace tumble {

namespace {

constexpr RayEntry kMisses{RayOutcome::misses, {}};

RayEntry entry_of(const CastContact& contact) {
    return contact.lower <= 1.0 ? RayEntry{RayOutcome::enters, contact} : kMisses;
}

// Each vertex as the ray sees it: its side of the line, and how far on it is; both times |v| and the scale.
struct SeenVertices {
    double scale;  // |q|^2
    double side[Shape::kInlineVertices];
    double ahead[Shape::kInlineVertices];
    unsigned left = 0;  // bit i: vertex i is on the left of the line or on it
};

// In the shape's own axes, scaled by |q|^2, where the vertices need no rotation.
SeenVertices see(const Core& core, DVec2 offset, DVec2 motion) {
    const double scale = core.c * core.c + core.s * core.s;
    const double ox = core.c * offset.x + core.s * offset.y, oy = core.c * offset.y - core.s * offset.x;
    const double vx = core.c * motion.x + core.s * motion.y, vy = core.c * motion.y - core.s * motion.x;
    SeenVertices seen;
    seen.scale = scale;
    for (int i = 0; i < Shape::kInlineVertices; ++i) {
        const double wx = scale * core.x[i] - ox, wy = scale * core.y[i] - oy;
        seen.side[i] = vx * wy - vy * wx;
        seen.ahead[i] = vx * wx + vy * wy;
    }
    for (unsigned i = 0; i < Shape::kInlineVertices; ++i) seen.left |= static_cast<unsigned>(seen.side[i] >= 0.0) << i;
    return seen;
}

double nearest_side(const SeenVertices& seen, int count) {
    double nearest = std::abs(seen.side[0]);
    for (int i = 1; i < count; ++i) nearest = std::min(nearest, std::abs(seen.side[i]));
    return nearest;
}

// Where the line crosses the face between two vertices, if clearly: by a margin from both ends.
struct Crossing {
    double along;  // 0 at the first vertex, 1 at the second
    double ahead;
    bool is_clear;
};

Crossing cross_face(const SeenVertices& seen, int from, int to, double margin) {
    const double side_from = seen.side[from], side_to = seen.side[to], along = side_from / (side_from - side_to);
    return {along, seen.ahead[from] + along * (seen.ahead[to] - seen.ahead[from]),
            std::abs(side_from) >= margin && std::abs(side_to) >= margin};
}

}  // namespace

RayEntry enter_lone_circle(const CorePair& pair, const CastPath& path) {
    const DVec2 center = pair.a.point(0) - pair.offset;
    const double gap = length(center) - path.reach;
    if (!(gap > path.error && path.reach > 16.0 * path.error && path.length > 0.0)) return {};
    const CircleEntry circle = meet_circle(path, center);
    if (!circle.is_met) return kMisses;
    if (!circle.is_certain) return {};
    const double inverse = 1.0 / path.length;
    const DVec2 normal = (1.0 / length(circle.from_center)) * circle.from_center;
    return entry_of({inverse * circle.entry, std::max(0.0, inverse * circle.lower), inverse * circle.upper,
                     -dot(normal, path.motion), {normal, {}, {}, 0.0}});
}

RayEntry enter_sharp_polygon(const CorePair& pair, const CastPath& path) {
    const Core& core = pair.a;
    const SeenVertices seen = see(core, pair.offset, path.motion);
    const auto count = static_cast<unsigned>(core.count), all = (1u << count) - 1u;
    const unsigned left = seen.left & all, next_left = ((left >> 1) | (left << (count - 1u))) & all;
    const unsigned entries = left & ~next_left, exits = ~left & next_left;
    const double margin = 2.0 * path.error * path.length * seen.scale;
    if (entries == 0) return nearest_side(seen, core.count) > margin ? kMisses : RayEntry{};
    if (std::popcount(entries) != 1) return {};
    const int from = std::countr_zero(entries), exit_from = std::countr_zero(exits);
    const Crossing entry = cross_face(seen, from, core.next(from), margin);
    const Crossing exit = cross_face(seen, exit_from, core.next(exit_from), margin);
    if (!entry.is_clear || !exit.is_clear) return {};
    if (exit.ahead < -margin) return kMisses;
    if (!(entry.ahead > margin)) return {};
    const DVec2 edge = core.edge(from, core.next(from));
    const DVec2 normal = (1.0 / length(edge)) * -perp(edge);
    const double rate = -dot(normal, path.motion), doubt = path.error / rate;
    if (!(rate > 0.0)) return {};
    const double fraction = entry.ahead / (seen.scale * path.length * path.length);
    const auto a = static_cast<std::uint16_t>(from), b = static_cast<std::uint16_t>(core.next(from));
    return entry_of({fraction, std::max(0.0, fraction - doubt), fraction + doubt, rate, {normal, {a, 0}, {b, 0}, entry.along}});
}

}  // namespace tumble
