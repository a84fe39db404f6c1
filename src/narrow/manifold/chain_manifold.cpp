// The manifold of a chain's segment: that of the lone segment is admitted, replaced or dropped, by the direction of its
// normal.
//
// A lone segment has an end face. If a body slides over a seam and its side is beyond the end by less than the overlap
// at its bottom, the end face pushes it back along the segment. A chain has no such surface: at a flat or hollow corner
// only the segment's own normal exists, at a round one the normals up to the neighbour's; all others belong to the
// neighbour.
#include <algorithm>

#include "debug/check.hpp"
#include "narrow/manifold/edge_manifold.hpp"
#include "narrow/manifold/link_contact.hpp"

namespace tumble {

namespace {

constexpr double kFlat = 0.01;     // rad: smaller corners count as flat
constexpr double kUpright = 1e-6;  // rad: the largest lean by rounding a normal to float
constexpr double kBeyond = 1e-3;   // rad: a normal farther than that beyond the neighbour's belongs to the neighbour

enum class Corner : std::uint8_t { free, flat_or_hollow, round };

// An end of the segment, in the orientation that has the open side on the right.
struct End {
    Corner corner = Corner::free;
    DVec2 normal;  // unit, of the neighbour
};

// The end between two edges that follow each other; `neighbour` is one of them.
End end_between(DVec2 first, DVec2 second, DVec2 neighbour) {
    const double lengths = length(first) * length(second), turn = cross(first, second);
    if (lengths == 0.0) return {};
    const bool is_round = turn > kFlat * lengths || (turn >= 0.0 && dot(first, second) < 0.0);
    return {is_round ? Corner::round : Corner::flat_or_hollow, (-1.0 / length(neighbour)) * perp(neighbour)};
}

// The segment in world axes relative to its body's position, with its open side on the right.
struct OpenSegment {
    int first;  // the core's vertex that it begins with
    DVec2 from;
    DVec2 edge;
    DVec2 tangent;  // unit
    DVec2 normal;   // unit, towards the open side
    End tail;
    End head;
};

OpenSegment open_segment(const Core& core, const ChainLink& link, bool is_reversed) {
    TUMBLE_CHECK(core.count == 2);
    OpenSegment segment;
    segment.first = is_reversed;
    segment.from = core.point(is_reversed);
    segment.edge = core.edge(is_reversed, !is_reversed);
    segment.tangent = (1.0 / length(segment.edge)) * segment.edge;
    segment.normal = -perp(segment.tangent);
    const DVec2 to = segment.from + segment.edge;
    const Vec2 before = is_reversed ? link.after : link.before, after = is_reversed ? link.before : link.after;
    const DVec2 edge_before = segment.from - core.turned(DVec2(before)), edge_after = core.turned(DVec2(after)) - to;
    if (is_reversed ? link.has_after : link.has_before)
        segment.tail = end_between(edge_before, segment.edge, edge_before);
    if (is_reversed ? link.has_before : link.has_after)
        segment.head = end_between(segment.edge, edge_after, edge_after);
    return segment;
}

// The middle of B's extents along and across a unit direction, relative to A's position.
DVec2 middle_of_b(const CorePair& pair, DVec2 along) {
    const auto middle = [&pair](DVec2 direction) {
        return 0.5 * (support(pair.b, direction).height - support(pair.b, -direction).height);
    };
    return pair.offset + middle(along) * along + middle(perp(along)) * perp(along);
}

// True if the middle of B is on the left of the chain, judged by the segment and its neighbours: by the segment's line
// beside it, by both lines of the corner beyond an end.
bool is_left(const CorePair& pair, const ChainLink& link) {
    const Core& core = pair.a;
    const DVec2 from = core.point(0), edge = core.edge(0, 1), to = from + edge;
    const DVec2 middle = middle_of_b(pair, (1.0 / length(edge)) * edge) - from;
    const bool is_left_of_edge = cross(edge, middle) > 0.0;
    const double along = dot(edge, middle);
    const bool is_before = along < 0.0 && link.has_before, is_after = along > length_sq(edge) && link.has_after;
    if (!is_before && !is_after) return is_left_of_edge;
    const DVec2 beside = is_before ? from - core.turned(DVec2(link.before)) : core.turned(DVec2(link.after)) - to;
    const bool is_left_of_neighbour = cross(beside, is_before ? middle : middle - edge) > 0.0;
    const double turn = is_before ? cross(beside, edge) : cross(edge, beside);
    return turn > 0.0 ? is_left_of_edge && is_left_of_neighbour : is_left_of_edge || is_left_of_neighbour;
}

enum class Verdict : std::uint8_t { admit, replace, drop };

Verdict judge(const OpenSegment& segment, DVec2 normal) {
    const double lean = dot(normal, segment.tangent);
    const bool is_upright = std::abs(lean) < kUpright && dot(normal, segment.normal) > 0.0;
    const End& end = lean < 0.0 ? segment.tail : segment.head;
    if (is_upright || end.corner == Corner::free) return Verdict::admit;
    if (end.corner == Corner::flat_or_hollow || dot(normal, segment.normal) <= 0.0) return Verdict::replace;
    const double beyond = lean < 0.0 ? cross(normal, end.normal) : cross(end.normal, normal);
    return beyond > kBeyond ? Verdict::drop : Verdict::admit;
}

// The points that lie beside the segment, not beyond an end of it.
void keep_points_beside(const OpenSegment& segment, double tolerance, Manifold& manifold) {
    const double run = length(segment.edge);
    int kept = 0;
    for (int i = 0; i < manifold.point_count; ++i) {
        const double along = dot(DVec2(manifold.points[i].anchor_a) - segment.from, segment.tangent);
        const bool is_beside = along >= -tolerance && along <= run + tolerance;
        if (is_beside) manifold.points[kept++] = manifold.points[i];
    }
    manifold.point_count = kept;
    TUMBLE_CHECK(kept <= 2);
}

}  // namespace

LinkContact find_link_contact(const Shape& a, const ChainLink& link, const Pose& world_from_a, const Shape& b,
                              const Pose& world_from_b, double speculative_distance, SimplexCache& cache) noexcept {
    const Manifold found = collide(a, world_from_a, b, world_from_b, speculative_distance, cache);
    if (found.point_count == 0) return {};
    if (a.vertex_count() != 2 || a.vertex(0) == a.vertex(1)) return {found, LinkSide::open};
    const CorePair pair = make_core_pair(a, world_from_a, b, world_from_b);
    const bool is_reversed = is_left(pair, link);
    if (is_reversed && link.one_sided) return {{}, LinkSide::solid};
    const OpenSegment segment = open_segment(pair.a, link, is_reversed);
    switch (judge(segment, DVec2(found.normal))) {
        case Verdict::admit: return {found, LinkSide::open};
        case Verdict::drop: return {{}, LinkSide::open};
        case Verdict::replace: break;
    }
    const double tolerance = kReferenceTolerance * speculative_distance;
    cache.reference_side = Side::a;
    cache.reference_edge = static_cast<std::uint16_t>(segment.first);
    Manifold manifold = edge_manifold(pair, {Side::a, segment.first, -1, {}}, {a.radius(), b.radius()},
                                      speculative_distance, tolerance);
    keep_points_beside(segment, tolerance, manifold);
    return {manifold, LinkSide::open};
}

Manifold collide_link(const Shape& a, const ChainLink& link, const Pose& world_from_a, const Shape& b,
                      const Pose& world_from_b, double speculative_distance, SimplexCache& cache) noexcept {
    return find_link_contact(a, link, world_from_a, b, world_from_b, speculative_distance, cache).manifold;
}

bool is_behind(const Shape& a, const ChainLink& link, const Pose& world_from_a, const Shape& b,
               const Pose& world_from_b) {
    if (!link.one_sided || a.vertex_count() != 2) return false;
    return is_left(make_core_pair(a, world_from_a, b, world_from_b), link);
}

}  // namespace tumble
