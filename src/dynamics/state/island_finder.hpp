// Which awake bodies belong together: a forest of disjoint sets over the solver bodies [Galler, Fischer 1964], joined
// by contacts and joints and made afresh whenever somebody may fall asleep.
//
// The root of a set is its lowest solver body, so that the sets do not depend on the order in which they were joined.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace tumble {

class IslandFinder {
public:
    // Every solver body on its own.
    void reset(std::size_t solver_body_count) {
        parent_.resize(solver_body_count);
        std::iota(parent_.begin(), parent_.end(), 0u);
        kept_awake_.assign(solver_body_count, 0);
    }

    std::uint32_t root(std::uint32_t body) {
        while (parent_[body] != body) body = parent_[body] = parent_[parent_[body]];
        return body;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t root_a = root(a), root_b = root(b);
        parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
    }

    // One body is enough to keep its island from sleeping.
    void keep_awake(std::uint32_t body) { kept_awake_[body] = 1; }
    bool is_kept_awake(std::uint32_t body) const { return kept_awake_[body] != 0; }

    std::size_t bytes() const { return parent_.capacity() * sizeof(std::uint32_t) + kept_awake_.capacity(); }

private:
    std::vector<std::uint32_t> parent_;  // by solver body
    std::vector<std::uint8_t> kept_awake_;
};

}  // namespace tumble
