// A set of pairs of keys: a hash table with open addressing and linear probing. It answers membership only and cannot
// be iterated, so that the order of its slots cannot affect any result.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tumble {

// Two proxies, by their keys, a < b: pairs sort by a, then b.
struct ProxyPair {
    std::uint32_t a = 0;
    std::uint32_t b = 0;

    friend constexpr auto operator<=>(ProxyPair, ProxyPair) = default;
};

constexpr ProxyPair make_pair_of(std::uint32_t x, std::uint32_t y) { return x < y ? ProxyPair{x, y} : ProxyPair{y, x}; }

class PairSet {
public:
    bool contains(ProxyPair pair) const;
    // Starts to load what contains() will read.
    void prefetch(ProxyPair pair) const {
        if (!slots_.empty()) __builtin_prefetch(&slots_[home(pack(pair))]);
    }
    void insert(ProxyPair pair);  // must not be contained yet
    void erase(ProxyPair pair);   // no effect if not contained
    std::size_t size() const { return size_; }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.slots_, self.size_);
    }

private:
    static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};
    static std::uint64_t pack(ProxyPair pair) { return std::uint64_t{pair.a} << 32 | pair.b; }
    // Multiplicative hashing by 2^64 / golden ratio, high bits folded down.
    std::size_t home(std::uint64_t packed) const {
        const std::uint64_t mixed = packed * 0x9e3779b97f4a7c15ull;
        return static_cast<std::size_t>(mixed ^ (mixed >> 32)) & (slots_.size() - 1);
    }
    std::size_t find_slot(std::uint64_t packed) const;  // of the pair, or the empty slot where it would be inserted
    void grow();

    std::vector<std::uint64_t> slots_;  // a power of two, at most half full
    std::size_t size_ = 0;
};

}  // namespace tumble
