// Finds pairs of proxies whose boxes overlap, each pair once, in order of their keys.
//
// A proxy is a box under a key. Fixed proxies never pair with each other. Only proxies that were added or moved since
// the last search are asked about; known pairs are remembered until they are forgotten.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "broad/pair_set.hpp"
#include "broad/tree.hpp"

namespace tumble {

enum class Mobility : std::uint8_t { fixed, moving };

class BroadPhase {
public:
    // Keys are small numbers: an array as long as the largest is kept.
    void add(std::uint32_t key, const Aabb& box, Mobility mobility);
    void remove(std::uint32_t key);
    void move(std::uint32_t key, const Aabb& box);

    // Asks about this proxy again in the next search, although its box is the same (a filter changed).
    void touch(std::uint32_t key);

    // True if a proxy was added, moved or touched since the last search: without it, no pair can have come or gone.
    bool has_moved() const { return !asked_.empty(); }

    const Aabb& box(std::uint32_t key) const { return proxies_[key].box; }
    bool overlap(ProxyPair pair) const { return overlaps(box(pair.a), box(pair.b)); }

    // The new pairs, sorted, for which accept(pair) holds; rejected pairs are not remembered. Valid until the next
    // call.
    template <class Accept>
    const std::vector<ProxyPair>& find_new_pairs(Accept&& accept);

    void forget(ProxyPair pair) { known_.erase(pair); }
    bool knows(ProxyPair pair) const { return known_.contains(pair); }
    std::size_t known_count() const { return known_.size(); }

    // Calls visit(key) for each proxy whose box overlaps, fixed ones first.
    template <class Visitor>
    void query(const Aabb& box, Visitor&& visit) const {
        fixed_.query(box, visit);
        moving_.query(box, visit);
    }

    // The same with any condition on boxes: see AabbTree::search().
    template <class MayHold, class Visitor>
    void search(MayHold&& may_hold, Visitor&& visit) const {
        fixed_.search(may_hold, visit);
        moving_.search(may_hold, visit);
    }

    void validate() const;

    // What is kept to be used again, bytes.
    std::size_t spare_bytes() const { return new_pairs_.capacity() * sizeof(ProxyPair); }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.fixed_, self.moving_, self.proxies_, self.asked_, self.known_);
    }

private:
    struct Proxy {
        Aabb box;
        AabbTree::Node leaf = AabbTree::kNone;  // kNone: no proxy under this key
        Mobility mobility = Mobility::fixed;
        bool is_asked = false;  // waits in asked_
    };

    AabbTree& tree(Mobility mobility) { return mobility == Mobility::fixed ? fixed_ : moving_; }

    AabbTree fixed_;
    AabbTree moving_;
    std::vector<Proxy> proxies_;        // by key
    std::vector<std::uint32_t> asked_;  // keys added, moved or touched since the last search
    std::vector<ProxyPair> new_pairs_;
    PairSet known_;
};

template <class Accept>
const std::vector<ProxyPair>& BroadPhase::find_new_pairs(Accept&& accept) {
    new_pairs_.clear();
    for (const std::uint32_t key : asked_) {
        const Proxy& proxy = proxies_[key];
        if (proxy.leaf == AabbTree::kNone) continue;
        const auto consider = [&](std::uint32_t other) {
            // Of two proxies that both ask, the one with the smaller key finds the pair.
            if (other == key || (proxies_[other].is_asked && other < key)) return;
            const ProxyPair pair = make_pair_of(key, other);
            if (!known_.contains(pair) && accept(pair)) new_pairs_.push_back(pair);
        };
        moving_.query(proxy.box, consider);
        if (proxy.mobility == Mobility::moving) fixed_.query(proxy.box, consider);
    }
    std::sort(new_pairs_.begin(), new_pairs_.end());
    for (const ProxyPair pair : new_pairs_) known_.insert(pair);
    for (const std::uint32_t key : asked_) proxies_[key].is_asked = false;
    asked_.clear();
    return new_pairs_;
}

}  // namespace tumble
