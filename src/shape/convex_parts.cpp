// Hertel, Mehlhorn 1983: a diagonal can be removed if the corners at both its ends are convex without it. In whatever
// order they are tried, no corner keeps more than two diagonals that it needs, which bounds the number of parts by four
// times the least.
#include "shape/convex_parts.hpp"

#include <algorithm>
#include <tuple>

#include "debug/check.hpp"

namespace tumble {

namespace {

// A face's boundary as a ring of half-edges, each with its face on the left.
class Faces {
public:
    Faces(const Ring& ring, std::span<const Triangle> triangles, std::size_t max_vertices)
        : ring_(ring), max_vertices_(max_vertices) {
        for (const Triangle& triangle : triangles) {
            const std::size_t first = half_edges_.size();
            for (std::size_t side = 0; side < 3; ++side)
                half_edges_.push_back({triangle[side], first + (side + 1) % 3, first + (side + 2) % 3, first / 3});
            sizes_.push_back(3);
            parents_.push_back(first / 3);
        }
    }

    // The two sides of each diagonal.
    std::vector<std::pair<std::size_t, std::size_t>> find_diagonals() const {
        std::vector<std::tuple<std::size_t, std::size_t, std::size_t>> by_ends;
        for (std::size_t h = 0; h < half_edges_.size(); ++h) {
            const auto [low, high] = std::minmax({origin(h), origin(half_edges_[h].next)});
            by_ends.emplace_back(low, high, h);
        }
        std::sort(by_ends.begin(), by_ends.end());
        std::vector<std::pair<std::size_t, std::size_t>> diagonals;
        for (std::size_t i = 1; i < by_ends.size(); ++i) {
            const auto& [low, high, side] = by_ends[i - 1];
            const auto& [other_low, other_high, other_side] = by_ends[i];
            if (low == other_low && high == other_high) diagonals.emplace_back(side, other_side);
        }
        return diagonals;
    }

    void try_remove(std::size_t side, std::size_t other_side) {
        if (!is_convex_without(side, other_side) || !is_convex_without(other_side, side)) return;
        TUMBLE_CHECK(origin(side) != origin(other_side));
        const std::size_t face = find(half_edges_[side].face), other_face = find(half_edges_[other_side].face);
        if (sizes_[face] + sizes_[other_face] - 2 > max_vertices_) return;
        TUMBLE_CHECK(face != other_face);
        parents_[other_face] = face;
        sizes_[face] += sizes_[other_face] - 2;
        TUMBLE_CHECK(sizes_[face] >= 4u);
        TUMBLE_CHECK(sizes_[face] <= max_vertices_);
        bypass(side, other_side);
        bypass(other_side, side);
        half_edges_[side].removed = half_edges_[other_side].removed = true;
    }

    std::vector<std::vector<std::size_t>> corners() const {
        std::vector<std::vector<std::size_t>> parts;
        std::vector<bool> seen(half_edges_.size(), false);
        for (std::size_t first = 0; first < half_edges_.size(); ++first) {
            if (half_edges_[first].removed || seen[first]) continue;
            std::vector<std::size_t>& part = parts.emplace_back();
            for (std::size_t h = first; !seen[h]; h = half_edges_[h].next) {
                seen[h] = true;
                part.push_back(origin(h));
            }
        }
        return parts;
    }

private:
    struct HalfEdge {
        std::size_t origin = 0;
        std::size_t next = 0;
        std::size_t previous = 0;
        std::size_t face = 0;
        bool removed = false;
    };

    std::size_t origin(std::size_t half_edge) const { return half_edges_[half_edge].origin; }

    // The corner at the origin of `side` without the diagonal. Both old corners are convex, so the new one is below a
    // full turn and its orientation decides.
    bool is_convex_without(std::size_t side, std::size_t other_side) const {
        const std::size_t before = half_edges_[side].previous, after = half_edges_[other_side].next;
        return orientation(ring_[origin(before)], ring_[origin(side)], ring_[origin(half_edges_[after].next)]) >= 0;
    }

    void bypass(std::size_t side, std::size_t other_side) {
        const std::size_t before = half_edges_[side].previous, after = half_edges_[other_side].next;
        half_edges_[before].next = after;
        half_edges_[after].previous = before;
    }

    std::size_t find(std::size_t face) {
        while (parents_[face] != face) face = parents_[face] = parents_[parents_[face]];
        return face;
    }

    const Ring& ring_;
    std::size_t max_vertices_;
    std::vector<HalfEdge> half_edges_;  // three of each triangle, in order
    std::vector<std::size_t> sizes_;    // [triangle] corners of its face, at the root of `parents_`
    std::vector<std::size_t> parents_;  // [triangle] the triangle that its face was joined to, or itself
};

}  // namespace

std::vector<std::vector<std::size_t>> merge_triangles(const Ring& ring, std::span<const Triangle> triangles,
                                                      std::size_t max_vertices) {
    Faces faces(ring, triangles, max_vertices);
    for (const auto& [side, other_side] : faces.find_diagonals()) faces.try_remove(side, other_side);
    return faces.corners();
}

}  // namespace tumble
