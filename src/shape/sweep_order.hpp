// The orders of a plane sweep over a ring of points: of its events from left to right, of its edges from below upwards.
//
// Events are ordered by is_before(): by x, then by y, which acts as an infinitesimal shear under which no edge is
// vertical. All comparisons are orientations of given points, hence exact (de Berg et al., Computational Geometry, 3rd
// ed., 2.1).
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "shape/orientation.hpp"
#include "tumble/math.hpp"

namespace tumble {

// A closed ring of points; edge i goes from point i to the next one.
class Ring {
public:
    explicit Ring(std::span<const Vec2> points) : points_(points) {}

    std::size_t size() const { return points_.size(); }
    Vec2 operator[](std::size_t index) const { return points_[index]; }
    std::size_t next(std::size_t index) const { return index + 1 < points_.size() ? index + 1 : 0; }
    std::size_t previous(std::size_t index) const { return index > 0 ? index - 1 : points_.size() - 1; }

    // The ends of an edge in sweep order.
    Vec2 left(std::size_t edge) const { return std::min(points_[edge], points_[next(edge)], is_before); }
    Vec2 right(std::size_t edge) const { return std::max(points_[edge], points_[next(edge)], is_before); }

    int turn(std::size_t index) const {
        return orientation(points_[previous(index)], points_[index], points_[next(index)]);
    }

    // All indices in sweep order; equal points by index.
    std::vector<std::size_t> events() const {
        std::vector<std::size_t> order(points_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(), [this](std::size_t i, std::size_t j) {
            return points_[i] == points_[j] ? i < j : is_before(points_[i], points_[j]);
        });
        return order;
    }

private:
    std::span<const Vec2> points_;
};

// True if the first of two edges, or of an edge and a point, lies below the second on the sweep line. Edges compare as
// equal only if the left end of one lies on the other, or if they leave one point in one direction.
class SweepOrder {
public:
    using is_transparent = void;

    explicit SweepOrder(const Ring& ring) : ring_(&ring) {}

    bool operator()(std::size_t edge, Vec2 point) const { return side(edge, point) > 0; }
    bool operator()(Vec2 point, std::size_t edge) const { return side(edge, point) < 0; }
    bool operator()(std::size_t edge, std::size_t other) const {
        const Vec2 start = ring_->left(edge), other_start = ring_->left(other);
        if (start == other_start) return side(edge, ring_->right(other)) > 0;
        return is_before(start, other_start) ? side(edge, other_start) > 0 : side(other, start) < 0;
    }

private:
    // +1 for a point above the edge.
    int side(std::size_t edge, Vec2 point) const { return orientation(ring_->left(edge), ring_->right(edge), point); }

    const Ring* ring_;
};

}  // namespace tumble
