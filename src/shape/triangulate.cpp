// Triangulation in one sweep: Hertel, Mehlhorn, Fast triangulation of the plane with respect to simple polygons, 1985.
//
// The sweep line cuts the polygon into intervals, each between a lower edge (the ring runs to the right, the region is
// above) and the upper edge after it. An interval keeps the front of what is triangulated on its left: a chain of
// corners from the left end of its lower edge to that of its upper edge, bent so that no three in a row can be joined
// from the right. A corner that the sweep reaches cuts off the triangles that it sees over the ends of the chain.
#include "shape/triangulate.hpp"

#include <iterator>
#include <map>

#include "debug/check.hpp"

namespace tumble {

namespace {

class Triangulation {
public:
    explicit Triangulation(const Ring& ring) : ring_(ring), intervals_(SweepOrder(ring)), iterators_(ring.size()) {
        triangles_.reserve(ring.size());
        nodes_.reserve(3 * ring.size());
    }

    std::vector<Triangle> run() {
        for (const std::size_t corner : ring_.events()) visit(corner);
        TUMBLE_CHECK(intervals_.empty());
        TUMBLE_CHECK(triangles_.size() + 2 == ring_.size());
        return std::move(triangles_);
    }

private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    struct Node {
        std::size_t corner = 0;
        std::size_t below = kNone;
        std::size_t above = kNone;
    };

    struct Interval {
        std::size_t lowest = kNone;
        std::size_t highest = kNone;
        std::size_t latest = kNone;  // the rightmost node of the chain: every later corner of the interval sees it
    };

    using Iterator = std::map<std::size_t, Interval, SweepOrder>::iterator;

    void visit(std::size_t corner) {
        const std::size_t incoming = ring_.previous(corner);
        const bool came_from_left = is_before(ring_[incoming], ring_[corner]);
        const bool goes_right = is_before(ring_[corner], ring_[ring_.next(corner)]);
        const bool is_convex = ring_.turn(corner) > 0;
        if (came_from_left && goes_right)
            follow_lower_edge(corner, incoming);
        else if (!came_from_left && !goes_right)
            extend_above(interval_below(corner)->second, corner);
        else if (goes_right)
            is_convex ? start(corner) : split(corner);
        else
            is_convex ? end(corner, incoming) : merge(corner, incoming);
    }

    void start(std::size_t corner) {
        const std::size_t node = add_node(corner);
        insert(corner, {node, node, node});
    }

    void follow_lower_edge(std::size_t corner, std::size_t incoming) {
        Interval interval = take(incoming);
        extend_below(interval, corner);
        insert(corner, interval);
    }

    void end(std::size_t corner, std::size_t incoming) {
        Interval interval = take(incoming);
        extend_below(interval, corner);
    }

    // The corner and the latest one of its interval become a diagonal between two intervals.
    void split(std::size_t corner) {
        Interval& lower = interval_below(corner)->second;
        const std::size_t hinge = lower.latest, twin = add_node(nodes_[hinge].corner);
        Interval upper{twin, lower.highest == hinge ? twin : lower.highest, twin};
        const std::size_t above = nodes_[hinge].above;
        if (above != kNone) link(twin, above);
        nodes_[hinge].above = kNone;
        lower.highest = hinge;
        extend_above(lower, corner);
        extend_below(upper, corner);
        insert(corner, upper);
    }

    // The upper edge of one interval and the lower edge of the next end here: their chains become one.
    void merge(std::size_t corner, std::size_t incoming) {
        Interval upper = take(incoming);
        Interval& lower = interval_below(corner)->second;
        extend_below(upper, corner);
        extend_above(lower, corner);
        const std::size_t above = nodes_[upper.lowest].above;
        link(lower.highest, above);
        lower.highest = upper.highest;
    }

    void extend_below(Interval& interval, std::size_t corner) {
        std::size_t end = interval.lowest;
        while (nodes_[end].above != kNone && cut(nodes_[end].corner, corner, nodes_[nodes_[end].above].corner))
            end = nodes_[end].above;
        const std::size_t node = add_node(corner);
        link(node, end);
        interval.lowest = interval.latest = node;
    }

    void extend_above(Interval& interval, std::size_t corner) {
        std::size_t end = interval.highest;
        while (nodes_[end].below != kNone && cut(nodes_[nodes_[end].below].corner, corner, nodes_[end].corner))
            end = nodes_[end].below;
        const std::size_t node = add_node(corner);
        link(end, node);
        interval.highest = interval.latest = node;
    }

    bool cut(std::size_t lower, std::size_t corner, std::size_t upper) {
        if (orientation(ring_[lower], ring_[corner], ring_[upper]) <= 0) return false;
        TUMBLE_CHECK(lower != upper);
        triangles_.push_back({lower, corner, upper});
        return true;
    }

    // Nodes that were cut off stay in the pool; the ends of a chain link to kNone.
    std::size_t add_node(std::size_t corner) {
        nodes_.push_back({corner, kNone, kNone});
        return nodes_.size() - 1;
    }

    void link(std::size_t below, std::size_t above) {
        nodes_[below].above = above;
        nodes_[above].below = below;
    }

    Iterator interval_below(std::size_t corner) { return std::prev(intervals_.upper_bound(ring_[corner])); }

    void insert(std::size_t edge, const Interval& interval) {
        iterators_[edge] = intervals_.emplace(edge, interval).first;
    }

    Interval take(std::size_t edge) {
        const Interval interval = iterators_[edge]->second;
        intervals_.erase(iterators_[edge]);
        return interval;
    }

    const Ring& ring_;
    std::map<std::size_t, Interval, SweepOrder> intervals_;  // by lower edge
    std::vector<Iterator> iterators_;                        // [edge], valid while it is a lower edge of intervals_
    std::vector<Node> nodes_;
    std::vector<Triangle> triangles_;
};

}  // namespace

std::vector<Triangle> triangulate(const Ring& ring) { return Triangulation(ring).run(); }

}  // namespace tumble
