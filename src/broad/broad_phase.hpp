// The broad phase: finds pairs of proxies whose boxes overlap, each pair once, in order of their keys.
//
// A proxy is a box with a key, in one of three layers, each with a tree of its own. A search looks for pairs of the
// proxies that were added, moved or touched since the last search. The broad phase keeps the pairs that it has found,
// and finds a pair again only after remove_pair().
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "broad/pair_set.hpp"
#include "broad/tree.hpp"
#include "debug/check.hpp"
#include "tasks/chunk_lists.hpp"

namespace tumble {

// Two fixed proxies are never a pair. The kinematic layer is for the few moving proxies that continuous collision must
// find without searching the dynamic ones: those of kinematic bodies, and of sensors on bodies that move.
enum class ProxyLayer : std::uint8_t { fixed, kinematic, dynamic };

class BroadPhase {
public:
    struct MovedProxy {
        std::uint32_t key = 0;
        Aabb box;  // the new one
    };

    // Adds a proxy under a key that has none, below 2^31. Memory grows with the largest key.
    void add(std::uint32_t key, const Aabb& box, ProxyLayer layer);
    void remove(std::uint32_t key);

    // Gives proxies, each once, other boxes, and touches them. Each node of a tree above them is refitted once, which
    // saves 20 to 35 % of the time where most proxies move; then those that have left their old boxes and their
    // siblings are inserted anew. `moved` is unspecified afterwards.
    void move(ChunkLists<MovedProxy>& moved, Crew& crew);

    // Makes the next search look for pairs of this proxy although its box is the same, as after a change of its filter.
    void touch(std::uint32_t key);

    // True if a proxy was added, moved or touched since the last search. If not, no pair has begun or ended.
    bool has_moved() const { return !touched_.empty(); }

    // True if this proxy was.
    bool has_moved(std::uint32_t key) const { return key < is_touched_.size() && is_touched_[key] != 0; }

    const Aabb& box(std::uint32_t key) const {
        TUMBLE_CHECK(has(key));
        return proxies_[key].box;
    }
    void prefetch(std::uint32_t key) const { __builtin_prefetch(&proxies_[key]); }  // starts to load a proxy
    bool has(std::uint32_t key) const { return key < proxies_.size() && proxies_[key].leaf != AabbTree::kNone; }

    // True if both proxies exist and their boxes overlap.
    bool overlap(ProxyPair pair) const { return has(pair.a) && has(pair.b) && overlaps(box(pair.a), box(pair.b)); }

    // Finds the new pairs for which accept(pair) is true, sorted. Rejected pairs are not kept: a later search
    // finds them again if one of their proxies is touched. The result is valid until the next call.
    // accept() is called by several threads at the same time.
    template <class Accept>
    const std::vector<ProxyPair>& find_new_pairs(Accept&& accept, Crew& crew);

    // Adds a pair as if it had been found. Its boxes may be apart.
    void add_pair(ProxyPair pair) { pairs_.insert(pair); }

    // The pairs found or added so far and not removed.
    void remove_pair(ProxyPair pair) { pairs_.erase(pair); }
    bool has_pair(ProxyPair pair) const { return pairs_.contains(pair); }
    std::size_t pair_count() const { return pairs_.size(); }

    // Calls visit(key) for each proxy of the layers `first` to `last` whose box overlaps `box`, layer by layer.
    template <class Visitor>
    void query(const Aabb& box, Visitor&& visit, ProxyLayer first = ProxyLayer::fixed,
               ProxyLayer last = ProxyLayer::dynamic) const {
        for (auto layer = static_cast<std::size_t>(first); layer <= static_cast<std::size_t>(last); ++layer)
            trees_[layer].query(box, visit);
    }

    // The same for all layers, with any condition on boxes: see AabbTree::search().
    template <class MayContain, class Visitor>
    void search(MayContain&& may_contain, Visitor&& visit) const {
        for (const AabbTree& tree : trees_) tree.search(may_contain, visit);
    }

    // Compares the proxies with the trees; throws std::logic_error that names the first broken invariant.
    void audit() const;

    // Bytes of the buffers that are kept from search to search.
    std::size_t spare_bytes() const {
        return new_pairs_.capacity() * sizeof(ProxyPair) + found_.bytes() +
               waiting_.capacity() * sizeof(AabbTree::NodePair) + changed_.capacity() * sizeof(AabbTree::Node);
    }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.trees_, self.proxies_, self.touched_, self.is_touched_, self.pairs_);
    }

private:
    struct Proxy {
        Aabb box;
        AabbTree::Node leaf = AabbTree::kNone;  // kNone: no proxy under this key
        ProxyLayer layer = ProxyLayer::fixed;
    };

    class TouchedMarks;

    static constexpr std::size_t kLeastQueries = 16;  // in a chunk: some us of work
    static constexpr std::size_t kLeastMarks = 256;   // to set or to remove
    static constexpr std::size_t kLeastLeaves = 64;   // touched ones, for the walk of a tree
    static constexpr std::size_t kPartsOfChunk = 4;   // subtrees or pairs of them: some take longer than others
    static constexpr std::size_t kNodesOfPart = 4;    // room for a subtree and nodes above it, in changed_

    std::size_t parts_of_walk(const Crew& crew) const;
    void refit(AabbTree& tree, Crew& crew);
    template <class Accept>
    void walk_dynamic(Accept& accept, Crew& crew);
    template <class Accept>
    void keep_new(std::vector<ProxyPair>& found, Accept& accept) const;
    template <class Visitor>
    void find_pairs_of(std::uint32_t key, Visitor&& visit) const;

    const AabbTree& tree(ProxyLayer layer) const { return trees_[static_cast<std::size_t>(layer)]; }
    AabbTree& tree(ProxyLayer layer) { return trees_[static_cast<std::size_t>(layer)]; }

    std::array<AabbTree, 3> trees_;         // by layer
    std::vector<Proxy> proxies_;            // by key
    std::vector<std::uint32_t> touched_;    // keys added, moved or touched since the last search
    std::vector<std::uint8_t> is_touched_;  // by key, 1 for these
    std::vector<ProxyPair> new_pairs_;
    ChunkLists<ProxyPair> found_;
    std::vector<AabbTree::NodePair> waiting_;  // parts of a walk of the dynamic tree
    std::vector<AabbTree::Node> changed_;      // parts of a tree to be refitted
    PairSet pairs_;
};

// One walk of the dynamic tree against itself finds the pairs of all touched dynamic proxies, in place of a query for
// each: the pairs of a drum of 2000 boxes take 0.63 ms instead of 1.30 ms, those of 11 000 falling bodies beside 28 000
// that sleep 3.1 ms instead of 4.3 ms.
template <class Accept>
const std::vector<ProxyPair>& BroadPhase::find_new_pairs(Accept&& accept, Crew& crew) {
    new_pairs_.clear();
    walk_dynamic(accept, crew);
    found_.fill_by_chunk(crew, touched_.size(), kLeastQueries, [&](const Chunk& chunk, std::vector<ProxyPair>& found) {
        for (std::size_t i = chunk.begin; i < chunk.end; ++i)
            find_pairs_of(touched_[i], [&](std::uint32_t other) { found.push_back(make_pair_of(touched_[i], other)); });
        keep_new(found, accept);
    });
    found_.for_each([&](ProxyPair pair) { new_pairs_.push_back(pair); });
    std::sort(new_pairs_.begin(), new_pairs_.end());
    for (const ProxyPair pair : new_pairs_) pairs_.insert(pair);
    for (const std::uint32_t key : touched_) is_touched_[key] = 0;
    touched_.clear();
    return new_pairs_;
}

// The marks of the touched dynamic proxies. They are removed also if a walk runs out of memory.
class BroadPhase::TouchedMarks {
public:
    TouchedMarks(BroadPhase& broad, Crew& crew) : broad_(broad), crew_(crew) {
        for_each_leaf([](AabbTree& tree, AabbTree::Node leaf) { tree.mark(leaf); });
    }
    ~TouchedMarks() {
        for_each_leaf([](AabbTree& tree, AabbTree::Node leaf) { tree.unmark(leaf); });
    }
    TouchedMarks(const TouchedMarks&) = delete;
    TouchedMarks& operator=(const TouchedMarks&) = delete;

private:
    template <class Act>
    void for_each_leaf(Act&& act) const {
        crew_.for_each(broad_.touched_.size(), kLeastMarks, [&](std::size_t i) {
            const Proxy& proxy = broad_.proxies_[broad_.touched_[i]];
            if (proxy.layer == ProxyLayer::dynamic && proxy.leaf != AabbTree::kNone)
                act(broad_.tree(ProxyLayer::dynamic), proxy.leaf);
        });
    }

    BroadPhase& broad_;
    Crew& crew_;
};

// Walks parts of the tree at the same time: pairs of its upper subtrees, which the first steps of the walk find.
template <class Accept>
void BroadPhase::walk_dynamic(Accept& accept, Crew& crew) {
    const AabbTree& tree = this->tree(ProxyLayer::dynamic);
    const TouchedMarks marks(*this, crew);
    const auto add_to = [](std::vector<ProxyPair>& found) {
        return [&](std::uint32_t a, std::uint32_t b) { found.push_back(make_pair_of(a, b)); };
    };
    tree.visit_upper_pairs(parts_of_walk(crew), waiting_, add_to(new_pairs_));
    keep_new(new_pairs_, accept);
    found_.fill_by_chunk(crew, waiting_.size(), kPartsOfChunk, [&](const Chunk& chunk, std::vector<ProxyPair>& found) {
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) tree.visit_pairs(waiting_[i], add_to(found));
        keep_new(found, accept);
    });
    found_.for_each([&](ProxyPair pair) { new_pairs_.push_back(pair); });
}

// Removes the pairs that are known or not accepted. Most are known, in slots that are far apart in memory: that of a
// later pair is loaded ahead, which saves a fifth of the search where a wall of 9600 boxes breaks.
template <class Accept>
void BroadPhase::keep_new(std::vector<ProxyPair>& found, Accept& accept) const {
    constexpr std::size_t kAhead = 8;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i + kAhead < found.size()) pairs_.prefetch(found[i + kAhead]);
        const ProxyPair pair = found[i];
        TUMBLE_CHECK(pair.a < pair.b);
        TUMBLE_CHECK(pair.b < proxies_.size());
        if (!pairs_.contains(pair) && accept(pair)) found[kept++] = pair;
    }
    found.resize(kept);
}

// Calls visit(other) for each proxy whose box overlaps that of a touched one, apart from those that the walk of the
// dynamic tree finds. Of two touched proxies the one with the smaller key finds the pair.
template <class Visitor>
void BroadPhase::find_pairs_of(std::uint32_t key, Visitor&& visit) const {
    const Proxy& proxy = proxies_[key];
    if (proxy.leaf == AabbTree::kNone) return;
    TUMBLE_CHECK(is_touched_[key] != 0);
    const auto visit_others = [&](std::uint32_t other) {
        if (other != key && !(is_touched_[other] && other < key)) visit(other);
    };
    const ProxyLayer first = proxy.layer == ProxyLayer::fixed ? ProxyLayer::kinematic : ProxyLayer::fixed;
    const bool is_dynamic = proxy.layer == ProxyLayer::dynamic;
    query(proxy.box, visit_others, first, is_dynamic ? ProxyLayer::kinematic : ProxyLayer::dynamic);
}

}  // namespace tumble
