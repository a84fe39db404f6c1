// Islands: a forest of disjoint sets of bodies [Galler, Fischer 1964] that contacts and joints connect, built anew
// for each search for islands at rest.
//
// The root of a set is its lowest body, so that the roots do not depend on the order of joining.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "debug/check.hpp"

namespace tumble {

class IslandFinder {
public:
    // Each body becomes a set of its own.
    void reset(std::size_t body_count) {
        parent_.resize(body_count);
        std::iota(parent_.begin(), parent_.end(), 0u);
        kept_awake_.assign(body_count, 0);
        supported_.assign(body_count, 0);
    }

    std::uint32_t root(std::uint32_t body) {
        TUMBLE_CHECK(body < parent_.size());
        while (parent_[body] != body) body = parent_[body] = parent_[parent_[body]];
        return body;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t root_a = root(a), root_b = root(b);
        parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
    }

    // Marks one body. The caller transfers the mark to the root: an island sleeps only if none of its bodies is marked.
    void keep_awake(std::uint32_t body) {
        TUMBLE_CHECK(body < kept_awake_.size());
        kept_awake_[body] = 1;
    }
    bool is_kept_awake(std::uint32_t body) const { return kept_awake_[body] != 0; }

    // Marks one body that touches or is joined to a body at rest that no impulse moves. The caller transfers this mark
    // too.
    void mark_supported(std::uint32_t body) {
        TUMBLE_CHECK(body < supported_.size());
        supported_[body] = 1;
    }
    bool is_supported(std::uint32_t body) const { return supported_[body] != 0; }

    std::size_t bytes() const {
        return parent_.capacity() * sizeof(std::uint32_t) + kept_awake_.capacity() + supported_.capacity();
    }

private:
    std::vector<std::uint32_t> parent_;     // by body
    std::vector<std::uint8_t> kept_awake_;  // by body, 0 or 1
    std::vector<std::uint8_t> supported_;   // by body, 0 or 1
};

}  // namespace tumble
