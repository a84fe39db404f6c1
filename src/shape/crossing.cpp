// Shamos, Hoey 1976: sweep the plane from left to right and test the edges that become neighbours on the sweep line.
// Just before the leftmost common point the edges through it are neighbours, so a crossing pair is found before the
// order of the edges can become wrong.
#include "shape/crossing.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

#include "debug/check.hpp"

namespace tumble {

namespace {

using EdgePair = std::pair<std::size_t, std::size_t>;

bool segments_meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const int c_side = orientation(a, b, c), d_side = orientation(a, b, d);
    const int a_side = orientation(c, d, a), b_side = orientation(c, d, b);
    if (c_side == 0 && d_side == 0) {  // on one line, where the sweep order is the order along it
        const auto [ab_first, ab_last] = std::minmax(a, b, is_before);
        const auto [cd_first, cd_last] = std::minmax(c, d, is_before);
        return !is_before(ab_last, cd_first) && !is_before(cd_last, ab_first);
    }
    return c_side * d_side <= 0 && a_side * b_side <= 0;
}

class CrossingSearch {
public:
    explicit CrossingSearch(const Ring& ring)
        : ring_(ring), edges_(SweepOrder(ring)), iterators_(ring.size(), edges_.end()) {}

    std::optional<EdgePair> run() {
        for (std::size_t corner = 0; corner < ring_.size() && !found_; ++corner) check_spike(corner);
        const std::vector<std::size_t> events = ring_.events();
        for (std::size_t event = 1; event < events.size() && !found_; ++event)
            if (ring_[events[event - 1]] == ring_[events[event]]) report(events[event - 1], events[event]);
        for (const std::size_t event : events) {
            if (found_) break;
            visit(event);
        }
        return found_;
    }

private:
    using Iterator = std::set<std::size_t, SweepOrder>::iterator;

    // Consecutive edges of the ring share more than their corner if the second turns back along the first.
    void check_spike(std::size_t corner) {
        const Vec2 before = ring_[ring_.previous(corner)], at = ring_[corner], after = ring_[ring_.next(corner)];
        if (ring_.turn(corner) == 0 && is_before(before, at) != is_before(at, after))
            report(ring_.previous(corner), corner);
    }

    void visit(std::size_t corner) {
        for (const std::size_t edge : {ring_.previous(corner), corner})
            if (ring_.right(edge) == ring_[corner]) remove(edge);
        for (const std::size_t edge : {ring_.previous(corner), corner})
            if (ring_.left(edge) == ring_[corner] && !found_) insert(edge);
    }

    void remove(std::size_t edge) {
        const Iterator above = edges_.erase(iterators_[edge]);
        if (above != edges_.begin() && above != edges_.end()) check(*std::prev(above), *above);
    }

    void insert(std::size_t edge) {
        const auto [entry, inserted] = edges_.insert(edge);
        if (!inserted) return report(*entry, edge);
        iterators_[edge] = entry;
        if (entry != edges_.begin()) check(*std::prev(entry), edge);
        if (std::next(entry) != edges_.end()) check(edge, *std::next(entry));
    }

    void check(std::size_t edge, std::size_t other) {
        if (ring_.next(edge) == other || ring_.next(other) == edge) return;
        if (segments_meet(ring_[edge], ring_[ring_.next(edge)], ring_[other], ring_[ring_.next(other)]))
            report(edge, other);
    }

    void report(std::size_t edge, std::size_t other) {
        TUMBLE_CHECK(edge != other);
        if (!found_) found_ = EdgePair(std::min(edge, other), std::max(edge, other));
    }

    const Ring& ring_;
    std::set<std::size_t, SweepOrder> edges_;  // those that cross the sweep line
    std::vector<Iterator> iterators_;          // [edge], valid while it is in edges_
    std::optional<EdgePair> found_;
};

}  // namespace

std::optional<EdgePair> find_crossing(const Ring& ring) { return CrossingSearch(ring).run(); }

}  // namespace tumble
